#include "armlet/math/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kHighestDegree = 50;

constexpr Index kBlock = 4096;  // points between two checkpoints

// The number of different values, up to the limit that a fit needs.
Index count_different(const VectorXd& x) {
  constexpr Index kEnough = kHighestDegree + 1;
  std::set<double> seen;
  for (Index i = 0; i < x.size() && static_cast<Index>(seen.size()) < kEnough; ++i) {
    if (i % kBlock == 0) checkpoint(64 * kBlock);
    seen.insert(x[i]);
  }
  return static_cast<Index>(seen.size());
}

// p((x - middle) / half) as a polynomial in x, by Horner's scheme with polynomials.
VectorXd unscaled(const VectorXd& p, double middle, double half) {
  VectorXd out = VectorXd::Zero(p.size());
  for (Index k = p.size(); k-- > 0;) {
    for (Index i = p.size() - 1; i > 0; --i) out[i] = (out[i - 1] - middle * out[i]) / half;
    out[0] = p[k] - middle * out[0] / half;
  }
  return out;
}

// The rows 1, t, t^2 ... for the points from `first` on, and after them y.
template <class Place>
void write_rows(Index first, Index count, const VectorXd& y, int degree, const Place& place,
                Eigen::MatrixXd& out, Index at) {
  for (Index i = 0; i < count; ++i) {
    out(at + i, 0) = 1.0;
    for (int k = 1; k <= degree; ++k) out(at + i, k) = out(at + i, k - 1) * place(first + i);
    out(at + i, degree + 1) = y[first + i];
  }
}

// Least squares by orthogonal factors: of all rows at once, or, if there are many, block after
// block, each below the triangular factor of the rows before it (G. H. Golub and C. F. Van Loan,
// Matrix Computations, 2013, section 6.5.3).
template <class Place>
VectorXd fit_scaled(Index count, const VectorXd& y, int degree, const Place& place) {
  const Index width = degree + 2;
  Index done = std::min(count, kBlock);
  Eigen::MatrixXd rows(done, width);
  write_rows(0, done, y, degree, place, rows, 0);
  while (done < count) {
    checkpoint(static_cast<std::uint64_t>(rows.rows() * width * width));
    const Eigen::MatrixXd before = rows;
    const Index kept = std::min(before.rows(), width);
    const Index more = std::min(count - done, kBlock);
    rows.setZero(kept + more, width);
    rows.topRows(kept) = triangle_of(before);
    write_rows(done, more, y, degree, place, rows, kept);
    done += more;
  }
  checkpoint(static_cast<std::uint64_t>(rows.rows() * width * width));
  const Eigen::MatrixXd powers = rows.leftCols(degree + 1);
  return nearest_solution(powers, rows.col(degree + 1));
}

}  // namespace

VectorXd fit_polynomial(const VectorXd& x, const VectorXd& y, int degree) {
  check_size("y", y.size(), x.size());
  check_finite("x", x);
  check_finite("y", y);
  if (degree < 0 || degree > kHighestDegree) {
    throw ArgumentError(fmt::format("The degree is {}; expected 0 to {}.", degree, kHighestDegree));
  }
  const Index different = count_different(x);
  if (different <= degree) {
    throw ArgumentError(
        fmt::format("A polynomial of degree {} needs {} points with different x, and there {} {}.",
                    degree, degree + 1, different == 1 ? "is" : "are", different));
  }
  const double middle = 0.5 * (x.minCoeff() + x.maxCoeff());
  const double width = 0.5 * (x.maxCoeff() - x.minCoeff());
  const double half = width > 0.0 ? width : 1.0;
  const auto place = [&](Index i) { return (x[i] - middle) / half; };
  const VectorXd scaled = fit_scaled(x.size(), y, degree, place);
  return unscaled(scaled, middle, half);
}

double value_between(const Eigen::Ref<const VectorXd>& x, const Eigen::Ref<const VectorXd>& y,
                     double at) {
  check_size("y", y.size(), x.size());
  if (x.size() == 0) throw ArgumentError("There are no points; expected at least one.");
  check_finite("x", x);
  check_finite("y", y);
  check_finite("at", at);
  for (Index i = 1; i < x.size(); ++i) {
    if (x[i - 1] < x[i]) continue;
    throw ArgumentError(
        fmt::format("The x must rise, but element {} is {:.15g} and element {} is {:.15g}.", i - 1,
                    x[i - 1], i, x[i]));
  }
  const Index last = x.size() - 1;
  if (at < x[0] || at > x[last]) {
    throw ArgumentError(fmt::format(
        "The points reach from {:.15g} to {:.15g}, and {:.15g} is outside.", x[0], x[last], at));
  }
  const Index right =
      std::clamp<Index>(std::upper_bound(x.data(), x.data() + x.size(), at) - x.data(),
                        std::min<Index>(1, last), last);
  if (right == 0) return y[0];
  const double part = (at - x[right - 1]) / (x[right] - x[right - 1]);
  // Exact at both ends.
  return part < 0.5 ? y[right - 1] + part * (y[right] - y[right - 1])
                    : y[right] - (1.0 - part) * (y[right] - y[right - 1]);
}

}  // namespace armlet
