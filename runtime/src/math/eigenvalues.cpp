#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "armlet/math/decompose.hpp"
#include "math/decompose_checks.hpp"
#include "math/solvers.hpp"

namespace armlet {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Error not_found() { return {"overflow", "the iteration for its eigenvalues did not end"}; }

std::vector<Index> ascending(const VectorXd& re, const VectorXd& im) {
  std::vector<Index> order(static_cast<std::size_t>(re.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(
      order, [&](Index a, Index b) { return re[a] != re[b] ? re[a] < re[b] : im[a] < im[b]; });
  return order;
}

// Length 1; the first entry of largest size, but for rounding, is positive.
void normalise(Eigen::Ref<VectorXd> v) {
  v.normalize();
  const double most = v.cwiseAbs().maxCoeff();
  for (const double entry : v) {
    if (std::abs(entry) < most * (1.0 - 1e-8)) continue;
    if (entry < 0.0) v *= -1.0;
    return;
  }
}

template <class Svd>
SvdParts parts_of(const Svd& svd) {
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

// By rotations where there are few rows or columns; dividing the matrix takes a twentieth of the
// time for 400 of both, which is 0.3 s. Where it does not converge, rotations do.
SvdParts decomposed(const MatrixXd& A, unsigned parts) {
  constexpr Index kByRotations = 32;
  if (std::min(A.rows(), A.cols()) > kByRotations) {
    const Eigen::BDCSVD<MatrixXd> svd(A, parts);
    SvdParts found = parts_of(svd);
    if (svd.info() == Eigen::Success && found.s.allFinite() && found.U.allFinite() &&
        found.V.allFinite())
      return found;
  }
  return parts_of(Eigen::JacobiSVD<MatrixXd>(A, parts));
}

MatrixXd symmetric_part(const MatrixXd& A) { return 0.5 * A + 0.5 * A.transpose(); }

}  // namespace

bool is_symmetric(const MatrixXd& A) {
  if (A.size() == 0) return true;
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const double most = A.cwiseAbs().maxCoeff();
  return (A - A.transpose()).cwiseAbs().maxCoeff() <= kRounding * most;
}

SvdParts singular_values(const MatrixXd& A) {
  check_matrix("A", A);
  if (A.size() == 0) return {MatrixXd::Zero(A.rows(), 0), VectorXd(), MatrixXd::Zero(A.cols(), 0)};
  return decomposed(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
}

SvdParts full_singular_values(const MatrixXd& A) {
  check_matrix("A", A);
  if (A.size() == 0) {
    return {MatrixXd::Identity(A.rows(), A.rows()), VectorXd(),
            MatrixXd::Identity(A.cols(), A.cols())};
  }
  return decomposed(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

Index rank(const MatrixXd& A) {
  const VectorXd s = singular_values(A).s;
  if (s.size() == 0) return 0;
  const auto longest = static_cast<double>(std::max(A.rows(), A.cols()));
  const double smallest = longest * std::numeric_limits<double>::epsilon() * s[0];
  return (s.array() > smallest).count();
}

Result<EigenvalueParts> eigenvalues(const MatrixXd& A) {
  check_square("A", A);
  if (A.size() == 0) return EigenvalueParts{};
  VectorXd re;
  VectorXd im = VectorXd::Zero(A.rows());
  if (is_symmetric(A)) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric_part(A), Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success) return not_found();
    re = solver.eigenvalues();
  } else {
    const Eigen::EigenSolver<MatrixXd> solver(A, false);
    if (solver.info() != Eigen::Success) return not_found();
    re = solver.eigenvalues().real();
    im = solver.eigenvalues().imag();
  }
  if (!re.allFinite() || !im.allFinite()) return not_found();
  const std::vector<Index> order = ascending(re, im);
  return EigenvalueParts{re(order), im(order)};
}

Result<EigenParts> eigenvectors(const MatrixXd& A) {
  check_square("A", A);
  if (A.size() == 0) return EigenParts{};
  EigenParts parts;
  if (is_symmetric(A)) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric_part(A));
    if (solver.info() != Eigen::Success) return not_found();
    parts = {solver.eigenvalues(), solver.eigenvectors()};
  } else {
    const Eigen::EigenSolver<MatrixXd> solver(A);
    if (solver.info() != Eigen::Success) return not_found();
    const VectorXd re = solver.eigenvalues().real();
    const VectorXd im = solver.eigenvalues().imag();
    for (Index i = 0; i < im.size(); ++i) {
      if (im[i] == 0.0) continue;
      return Error{"complex",
                   fmt::format("two of its eigenvalues are {:.6g} + {:.6g}i and {:.6g} - {:.6g}i",
                               re[i], std::abs(im[i]), re[i], std::abs(im[i]))};
    }
    const std::vector<Index> order = ascending(re, im);
    parts = {re(order), solver.pseudoEigenvectors()(Eigen::all, order)};
  }
  if (!parts.values.allFinite() || !parts.vectors.allFinite()) return not_found();
  for (auto column : parts.vectors.colwise()) normalise(column);
  return parts;
}

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double smallest_eigenvalue(const MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace armlet
