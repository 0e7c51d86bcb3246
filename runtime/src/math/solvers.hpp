// Solvers of Eigen for all layers, compiled once (solvers.cpp, eigenvalues.cpp): a source that
// instantiates its own takes ten seconds more to compile.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

namespace armlet {

// L D L^T of a symmetric matrix that is not negative; N rows, or Eigen::Dynamic.
template <int N>
class SymmetricFactors {
 public:
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  explicit SymmetricFactors(const Matrix& A);
  [[nodiscard]] Vector solve(const Vector& b) const;
  [[nodiscard]] Eigen::MatrixXd solve_all(const Eigen::MatrixXd& B) const;

 private:
  Eigen::LDLT<Matrix> factors_;
};
extern template class SymmetricFactors<3>;
extern template class SymmetricFactors<6>;
extern template class SymmetricFactors<Eigen::Dynamic>;

// P L U of a square matrix that is not singular.
class SquareFactors {
 public:
  explicit SquareFactors(const Eigen::MatrixXd& A);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

// Of any matrix: the shortest x for which A x is nearest to b. Pivots up to `threshold` times the
// largest count as zero.
class OrthogonalFactors {
 public:
  OrthogonalFactors(const Eigen::MatrixXd& A, double threshold);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors_;
};

// The x for which A x is nearest to b; A has full column rank.
[[nodiscard]] Eigen::VectorXd nearest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

// R of A = Q R, min(rows, columns) rows; entries below the diagonal are zero.
[[nodiscard]] Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& A);

// Eigenvalues in ascending order, and the eigenvectors of length 1 that belong to them as columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// Of a symmetric matrix, of which the lower triangle is read.
[[nodiscard]] SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
[[nodiscard]] double smallest_eigenvalue(const Eigen::MatrixXd& A);

// The rotation by the smallest angle after which the z axis has the direction `along`, which is not
// zero.
[[nodiscard]] Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& along);

// The direction across all rows, of which there is one fewer than columns: what is left when they
// are taken out of it one by one, from the right end of a decomposition with pivots.
[[nodiscard]] Eigen::VectorXd direction_across(const Eigen::MatrixXd& rows);

}  // namespace armlet
