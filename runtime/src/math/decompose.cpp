#include "armlet/math/decompose.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/MatrixFunctions>

#include "armlet/math/check_finite.hpp"
#include "math/decompose_checks.hpp"

namespace armlet {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// what: "row" or "column".
Error singular(Index rank, Index needed, std::string_view what) {
  return {"singular", fmt::format("its rank is {}, but {} independent {}{} needed", rank, needed,
                                  what, needed == 1 ? " is" : "s are")};
}

// The rank, found by QR with column exchanges.
Index rank_by_qr(const MatrixXd& A) { return Eigen::ColPivHouseholderQR<MatrixXd>(A).rank(); }

// The LU factors of a square matrix that is not singular.
Result<Eigen::PartialPivLU<MatrixXd>> factors(const MatrixXd& A) {
  Eigen::PartialPivLU<MatrixXd> lu(A);
  constexpr double kSmallest = std::numeric_limits<double>::epsilon();
  const bool zero_pivot = A.rows() > 0 && !(lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0.0);
  if (zero_pivot || !(lu.rcond() >= kSmallest)) {
    // If QR finds full rank although rounding hides a defect, the rank is one less.
    const Index seen = rank_by_qr(A);
    return singular(seen < A.rows() ? seen : A.rows() - 1, A.rows(), "row");
  }
  return lu;
}

Result<MatrixXd> least_squares(const MatrixXd& A, const MatrixXd& B) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  if (qr.rank() < A.cols()) return singular(qr.rank(), A.cols(), "column");
  return finite(qr.solve(B));
}

Result<MatrixXd> smallest_solution(const MatrixXd& A, const MatrixXd& B) {
  const Eigen::CompleteOrthogonalDecomposition<MatrixXd> cod(A);
  if (cod.rank() < A.rows()) return singular(cod.rank(), A.rows(), "row");
  return finite(cod.solve(B));
}

}  // namespace

void check_matrix(std::string_view name, const MatrixXd& A) {
  check_finite(name, A);
  if (A.rows() <= kMostDecomposed && A.cols() <= kMostDecomposed) return;
  throw ArgumentError(fmt::format("`{}` is {}x{}; at most {} rows and columns are possible.", name,
                                  A.rows(), A.cols(), kMostDecomposed));
}

void check_square(std::string_view name, const MatrixXd& A) {
  check_matrix(name, A);
  if (A.rows() == A.cols()) return;
  throw ArgumentError(
      fmt::format("`{}` is {}x{}; a square matrix is expected.", name, A.rows(), A.cols()));
}

Result<MatrixXd> finite(MatrixXd result) {
  if (result.allFinite()) return result;
  return Error{"overflow", "the numbers of the result are too large for a double"};
}

Result<MatrixXd> solve(const MatrixXd& A, const MatrixXd& B) {
  check_matrix("A", A);
  check_finite("B", B);
  check_size("B", B.rows(), A.rows());
  if (A.size() == 0) return MatrixXd(MatrixXd::Zero(A.cols(), B.cols()));
  if (A.rows() > A.cols()) return least_squares(A, B);
  if (A.rows() < A.cols()) return smallest_solution(A, B);
  const auto lu = factors(A);
  if (!lu) return lu.error();
  return finite(lu->solve(B));
}

Result<MatrixXd> inverse(const MatrixXd& A) {
  check_square("A", A);
  return solve(A, MatrixXd::Identity(A.rows(), A.cols()));
}

Result<double> determinant(const MatrixXd& A) {
  check_square("A", A);
  const double det = A.size() == 0 ? 1.0 : Eigen::PartialPivLU<MatrixXd>(A).determinant();
  if (std::isfinite(det)) return det;
  return Error{"overflow", "the determinant is too large for a double"};
}

LuParts lu_decomposition(const MatrixXd& A) {
  check_square("A", A);
  const Index n = A.rows();
  LuParts parts{MatrixXd::Identity(n, n), MatrixXd::Zero(n, n), MatrixXd::Zero(n, n)};
  if (n == 0) return parts;
  const Eigen::PartialPivLU<MatrixXd> lu(A);
  parts.L.triangularView<Eigen::StrictlyLower>() = lu.matrixLU();
  parts.U.triangularView<Eigen::Upper>() = lu.matrixLU();
  parts.P = lu.permutationP() * MatrixXd::Identity(n, n);
  return parts;
}

QrParts qr_decomposition(const MatrixXd& A) {
  check_matrix("A", A);
  const Index k = std::min(A.rows(), A.cols());
  QrParts parts{MatrixXd::Identity(A.rows(), k), MatrixXd::Zero(k, A.cols())};
  if (k == 0) return parts;
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  parts.Q = qr.householderQ() * parts.Q;
  parts.R.triangularView<Eigen::Upper>() = qr.matrixQR().topRows(k);
  for (Index i = 0; i < k; ++i) {
    if (!(parts.R(i, i) < 0.0)) continue;
    parts.R.row(i) *= -1.0;
    parts.Q.col(i) *= -1.0;
  }
  return parts;
}

Result<MatrixXd> cholesky(const MatrixXd& A) {
  check_square("A", A);
  if (!is_symmetric(A)) return Error{"not_symmetric", "the matrix is not symmetric"};
  if (A.size() == 0) return A;
  const Eigen::LLT<MatrixXd> llt(A);
  const MatrixXd L = llt.matrixL();
  if (llt.info() == Eigen::Success && L.allFinite()) return L;
  const auto values = eigenvalues(A);
  return Error{"not_positive",
               values ? fmt::format("its smallest eigenvalue is {:.6g}", values->re.minCoeff())
                      : "it has an eigenvalue that is not positive"};
}

Result<MatrixXd> exponential(const MatrixXd& A) {
  check_square("A", A);
  if (A.size() == 0) return A;
  // Beyond this bound every element of the result is infinite or zero, and the squarings would not
  // end.
  constexpr double kLargest = 1e5;
  const double size = A.cwiseAbs().colwise().sum().maxCoeff();
  if (!(size <= kLargest)) {
    return Error{"overflow", fmt::format("the largest sum of a column is {:.6g}; at most {:.0g} "
                                         "is possible",
                                         size, kLargest)};
  }
  return finite(A.exp());
}

}  // namespace armlet
