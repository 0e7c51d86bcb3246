#include "armlet/math/fit.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <vector>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kHighestDegree = 50;

Index count_different(const VectorXd& x) {
  std::vector<double> sorted(x.begin(), x.end());
  std::ranges::sort(sorted);
  return std::unique(sorted.begin(), sorted.end()) - sorted.begin();
}

// p((x - middle) / half) as a polynomial in x, by Horner's scheme on polynomials.
VectorXd unscaled(const VectorXd& p, double middle, double half) {
  VectorXd out = VectorXd::Zero(p.size());
  for (Index k = p.size(); k-- > 0;) {
    for (Index i = p.size() - 1; i > 0; --i) out[i] = (out[i - 1] - middle * out[i]) / half;
    out[0] = p[k] - middle * out[0] / half;
  }
  return out;
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
  Eigen::MatrixXd powers(x.size(), degree + 1);
  powers.col(0).setOnes();
  for (int k = 1; k <= degree; ++k) {
    for (Index i = 0; i < x.size(); ++i) powers(i, k) = powers(i, k - 1) * ((x[i] - middle) / half);
  }
  const VectorXd scaled = powers.colPivHouseholderQr().solve(y);
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
