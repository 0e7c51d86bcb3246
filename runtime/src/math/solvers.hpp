// Solvers of Eigen for all layers, compiled once (solvers.cpp, eigenvalues.cpp): a source that
// instantiates them itself takes ten seconds longer to compile.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>

namespace armlet {

// The decomposition L D L^T of a positive semidefinite matrix; N rows, or Eigen::Dynamic.
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

// The decomposition P L U of a regular square matrix.
class SquareFactors {
 public:
  explicit SquareFactors(const Eigen::MatrixXd& A);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

// The least-squares solution of A x = b with the smallest norm, for any matrix A. Pivots up to
// `threshold` times the largest count as zero.
class OrthogonalFactors {
 public:
  OrthogonalFactors(const Eigen::MatrixXd& A, double threshold);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors_;
};

// The least-squares solution of A x = b; A must have full column rank.
[[nodiscard]] Eigen::VectorXd nearest_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

// The factor R of A = Q R, with min(rows, columns) rows; entries below the diagonal are zero.
[[nodiscard]] Eigen::MatrixXd triangle_of(const Eigen::MatrixXd& A);

// Eigenvalues in ascending order, and the eigenvectors of unit length as columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// The eigenvalues of a symmetric matrix, whose lower triangle is read.
[[nodiscard]] SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
[[nodiscard]] double smallest_eigenvalue(const Eigen::MatrixXd& A);

// The rotation by the smallest angle that moves the z axis to the direction `along`, which must not
// be zero.
[[nodiscard]] Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& along);

// The direction orthogonal to all rows of a matrix with one row fewer than columns. It is the
// column that is left at the end of a QR decomposition with pivots.
[[nodiscard]] Eigen::VectorXd direction_across(const Eigen::MatrixXd& rows);

}  // namespace armlet
