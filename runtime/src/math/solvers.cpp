#include "math/solvers.hpp"

#include <algorithm>

#include "armlet/math/det_math.hpp"

namespace armlet {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <int N>
SymmetricFactors<N>::SymmetricFactors(const Matrix& A) : factors_(A) {}

template <int N>
typename SymmetricFactors<N>::Vector SymmetricFactors<N>::solve(const Vector& b) const {
  return factors_.solve(b);
}

template <int N>
MatrixXd SymmetricFactors<N>::solve_all(const MatrixXd& B) const {
  return factors_.solve(B);
}

template class SymmetricFactors<3>;
template class SymmetricFactors<6>;
template class SymmetricFactors<Eigen::Dynamic>;

SquareFactors::SquareFactors(const MatrixXd& A) : factors_(A) {}
VectorXd SquareFactors::solve(const VectorXd& b) const { return factors_.solve(b); }

OrthogonalFactors::OrthogonalFactors(const MatrixXd& A, double threshold) {
  factors_.setThreshold(threshold);
  factors_.compute(A);
}
VectorXd OrthogonalFactors::solve(const VectorXd& b) const { return factors_.solve(b); }

VectorXd nearest_solution(const MatrixXd& A, const VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

MatrixXd triangle_of(const MatrixXd& A) {
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  const Eigen::Index kept = std::min(A.rows(), A.cols());
  MatrixXd R = MatrixXd::Zero(kept, A.cols());
  R.triangularView<Eigen::Upper>() = qr.matrixQR().topRows(kept);
  return R;
}

Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& along) {
  const Eigen::Vector3d n = along.normalized();
  if (n.z() > -0.5)
    return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix();
  // Near the opposite direction Eigen divides by 1 + n.z(), which has few correct digits there.
  const double across = det::hypot(n.x(), n.y());
  const double c = across > 0.0 ? n.x() / across : 0.0, s = across > 0.0 ? n.y() / across : 1.0;
  const double k = 1.0 - n.z();
  Eigen::Matrix3d R;
  R << 1.0 - c * c * k, -c * s * k, n.x(),  //
      -c * s * k, 1.0 - s * s * k, n.y(),   //
      -n.x(), -n.y(), n.z();
  return R;
}

VectorXd direction_across(const MatrixXd& rows) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows.transpose());
  return qr.householderQ() * VectorXd::Unit(rows.cols(), rows.cols() - 1);
}

}  // namespace armlet
