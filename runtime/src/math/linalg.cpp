#include "armlet/math/linalg.hpp"

#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/decompose.hpp"

namespace armlet {

Eigen::MatrixXd damped_pseudo_inverse(const Eigen::MatrixXd& J, double lambda) {
  check_finite("J", J);
  check_finite("lambda", lambda);
  if (lambda < 0.0) throw ArgumentError("`lambda` is negative; damping must be zero or more.");
  if (J.size() == 0) return Eigen::MatrixXd::Zero(J.cols(), J.rows());
  const SvdParts svd = singular_values(J);
  Eigen::VectorXd inverse = svd.s;
  const double smallest = 1e-12 * inverse[0];
  for (double& sigma : inverse) {
    sigma = sigma > smallest ? sigma / (sigma * sigma + lambda * lambda) : 0.0;
  }
  return svd.V * inverse.asDiagonal() * svd.U.transpose();
}

Eigen::MatrixXd null_space_projector(const Eigen::MatrixXd& J, double tolerance) {
  check_finite("J", J);
  const Eigen::Index n = J.cols();
  if (J.size() == 0) return Eigen::MatrixXd::Identity(n, n);
  const SvdParts svd = singular_values(J);
  const Eigen::Index rank = (svd.s.array() > tolerance * svd.s[0]).count();
  const Eigen::MatrixXd V = svd.V.leftCols(rank);
  return Eigen::MatrixXd::Identity(n, n) - V * V.transpose();
}

double condition_number(const Eigen::MatrixXd& A) {
  check_finite("A", A);
  if (A.size() == 0) throw ArgumentError("`A` is empty; it has no condition number.");
  const Eigen::VectorXd sigma = singular_values(A).s;
  const double smallest = sigma[sigma.size() - 1];
  return smallest > 0.0 ? sigma[0] / smallest : std::numeric_limits<double>::infinity();
}

}  // namespace armlet
