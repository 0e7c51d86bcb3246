#include "armlet/math/real_roots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/polynomial.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kHighestDegree = 50;

// The sign of the value: -1, 0 or 1; also 0 if it may be the result of rounding errors.
int sign_at(const VectorXd& c, double x) {
  double value = 0.0;
  double size = 0.0;
  for (Index k = c.size(); k-- > 0;) {
    value = value * x + c[k];
    size = size * std::abs(x) + std::abs(c[k]);
  }
  if (!std::isfinite(size))
    throw ArgumentError("The coefficients differ too much in size for the range of a double.");
  // Twice the bound of N. Higham, Accuracy and Stability of Numerical Algorithms, 2002, eq. 5.3,
  // because the coefficients are rounded too.
  const double doubt =
      4.0 * static_cast<double>(c.size()) * std::numeric_limits<double>::epsilon() * size;
  if (std::abs(value) <= doubt) return 0;
  return value < 0.0 ? -1 : 1;
}

// The zero of the polynomial, which is monotone from lo to hi, by bisection.
double crossing(const VectorXd& c, double lo, double hi, bool rising) {
  for (;;) {
    const double middle = lo + 0.5 * (hi - lo);
    if (!(middle > lo && middle < hi)) break;
    const double value = polynomial_value(c, middle);
    if (value == 0.0) return middle;
    ((value < 0.0) == rising ? lo : hi) = middle;
  }
  return std::abs(polynomial_value(c, lo)) < std::abs(polynomial_value(c, hi)) ? lo : hi;
}

// A bound for the absolute values of the roots (M. Fujiwara, Tohoku Mathematical Journal 10, 1916).
double bound_of(const VectorXd& c) {
  const Index n = c.size() - 1;
  double most = 0.0;
  for (Index k = 1; k <= n; ++k)
    most = std::max(most, det::pow(std::abs(c[n - k] / c[n]), 1.0 / static_cast<double>(k)));
  if (!std::isfinite(most))
    throw ArgumentError("The coefficients differ too much in size for the range of a double.");
  return 2.0 * most + std::numeric_limits<double>::min();
}

// c must have at least two coefficients, the highest of them not zero.
std::vector<double> roots_of(const VectorXd& c) {
  const double bound = bound_of(c);
  if (c.size() == 2) return {-c[0] / c[1]};
  std::vector<double> grid = roots_of(polynomial_derivative(c));
  grid.push_back(bound);
  std::vector<double> roots;
  // Beyond the bound the sign is that of the highest term.
  const int last = c[c.size() - 1] > 0.0 ? 1 : -1;
  int before = c.size() % 2 == 1 ? last : -last;
  double from = -bound;
  for (const double to : grid) {
    const int here = to == bound ? last : sign_at(c, to);
    if (before * here < 0) roots.push_back(crossing(c, from, to, here > 0));
    if (here == 0) roots.push_back(to);
    before = here;
    from = to;
  }
  return roots;
}

}  // namespace

std::vector<double> real_roots(const VectorXd& c) {
  check_finite("c", c);
  Index size = c.size();
  while (size > 0 && c[size - 1] == 0.0) --size;
  if (size == 0)
    throw ArgumentError(
        "All coefficients are zero, so every number is a root; expected one that is not.");
  if (size - 1 > kHighestDegree) {
    throw ArgumentError(fmt::format("The polynomial has degree {}; expected at most {}.", size - 1,
                                    kHighestDegree));
  }
  if (size == 1) return {};
  // Roots at zero are divided out exactly.
  Index zeros = 0;
  while (c[zeros] == 0.0) ++zeros;
  std::vector<double> roots;
  if (zeros + 1 < size) roots = roots_of(c.segment(zeros, size - zeros));
  if (zeros > 0) roots.insert(std::ranges::upper_bound(roots, 0.0), 0.0);
  return roots;
}

}  // namespace armlet
