#pragma once

#include <Eigen/Core>

#include "armlet/core/error.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Linear algebra on matrices of any size up to kMostDecomposed rows and columns.
//
// Every function throws ArgumentError if an element is not finite, if the matrix is larger than
// that, or if it has to be square and is not. Where a number of the result would be too large for a
// double, the result is the error "overflow".
// source  G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013.

// Up to this size the order of sums does not depend on the size of caches.
inline constexpr Eigen::Index kMostDecomposed = 400;

// X, n x k, with A X = B, A m x n and B m x k. A square A is solved by LU with row exchanges, or
// the error "singular". With more rows than columns: least squares by QR, or "singular" if the
// columns are linearly dependent. With fewer rows: of all solutions the smallest, or "singular" if
// the rows are linearly dependent.
Result<Eigen::MatrixXd> solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

// The inverse; "singular" if A has none that differs from the effect of rounding.
Result<Eigen::MatrixXd> inverse(const Eigen::MatrixXd& A);
// The determinant of a square matrix.
Result<double> determinant(const Eigen::MatrixXd& A);

// The number of singular values above max(rows, cols) * 2^-52 times the largest.
Eigen::Index rank(const Eigen::MatrixXd& A);

// P A = L U with rows exchanged for the largest pivots: L has ones on its diagonal.
struct LuParts {
  Eigen::MatrixXd L, U, P;
};
LuParts lu_decomposition(const Eigen::MatrixXd& A);

// A = Q R: columns of Q orthonormal, R upper triangular with no negative number on its diagonal.
// Q is m x k and R is k x n, k the smaller of m and n.
struct QrParts {
  Eigen::MatrixXd Q, R;
};
QrParts qr_decomposition(const Eigen::MatrixXd& A);

// Lower triangular L with L L^T = A, or the error "not_symmetric" or "not_positive".
Result<Eigen::MatrixXd> cholesky(const Eigen::MatrixXd& A);

// A = U diag(s) V^T: columns of U and V orthonormal, s in descending order, as many as the smaller
// of rows and columns.
struct SvdParts {
  Eigen::MatrixXd U;
  Eigen::VectorXd s;
  Eigen::MatrixXd V;
};
SvdParts singular_values(const Eigen::MatrixXd& A);
// The singular value decomposition with square U and V: the additional columns span the complements
// of the range and of the row space of A.
SvdParts full_singular_values(const Eigen::MatrixXd& A);

// Eigenvalues in ascending order of their real parts, then of their imaginary parts; all
// imaginary parts are exactly zero for a symmetric matrix.
struct EigenvalueParts {
  Eigen::VectorXd re, im;
};
Result<EigenvalueParts> eigenvalues(const Eigen::MatrixXd& A);

// Real eigenvalues in ascending order and an eigenvector for each, of length 1, whose first entry
// of largest size is positive; orthonormal for a symmetric matrix. The error "complex" if an
// eigenvalue is not real.
struct EigenParts {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
Result<EigenParts> eigenvectors(const Eigen::MatrixXd& A);

// e^A = I + A + A A / 2 + ...: scaling and squaring with Pade approximants.
// source  N. J. Higham, SIAM J. Matrix Anal. Appl. 26(4), 2005.
Result<Eigen::MatrixXd> exponential(const Eigen::MatrixXd& A);

}  // namespace armlet
