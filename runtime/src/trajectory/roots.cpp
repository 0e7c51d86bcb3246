#include "trajectory/roots.hpp"

#include <cmath>

namespace armlet {
namespace {

// A derivative of a piece as a polynomial with the same values as Segment::value.
struct Derivative {
  int degree = 0;
  std::array<double, Segment::kMaxDegree + 1> c{};

  Derivative(const Segment& piece, int order) : degree(piece.degree - order) {
    for (int k = order; k <= piece.degree; ++k) {
      double factor = 1.0;
      for (int j = 0; j < order; ++j) factor *= k - j;
      c[static_cast<std::size_t>(k - order)] = factor * piece.c[static_cast<std::size_t>(k)];
    }
  }

  [[nodiscard]] double value(double u) const {
    double sum = 0.0;
    for (int k = degree; k >= 0; --k) sum = sum * u + c[static_cast<std::size_t>(k)];
    return sum;
  }
};

// Newton's method restricted to [lo, hi], where the polynomial is monotone and changes its sign. A
// step that would leave the interval is replaced by bisection.
//
// source  W. H. Press et al., Numerical Recipes, 3rd ed., 2007, section 9.4.
double root_between(const Derivative& polynomial, const Derivative& slope, double lo, double hi,
                    bool rising, double duration) {
  double u = 0.5 * (lo + hi);
  constexpr int kMostSteps = 200;  // far more than bisection alone would take
  for (int k = 0; k < kMostSteps; ++k) {
    const double value = polynomial.value(u);
    ((value < 0.0) == rising ? lo : hi) = u;
    double next = u - value / slope.value(u);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - u) <= 1e-15 * duration) return next;
    u = next;
  }
  return u;
}

}  // namespace

Roots sign_changes(const Segment& piece, int order) {
  // Between neighbouring extremes a polynomial is monotone, so it has at most one root there: from
  // the constant derivative down, the roots of each are the extremes of the next.
  Roots roots;
  Derivative slope(piece, piece.degree + 1);
  for (int k = piece.degree; k >= order; --k) {
    const Derivative polynomial(piece, k);
    Roots found;
    double from = 0.0;
    double a = polynomial.value(from);
    const auto look_until = [&](double to) {
      const double b = polynomial.value(to);
      if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
        found.push_back(root_between(polynomial, slope, from, to, a < 0.0, piece.duration));
      } else if (a == 0.0 && from > 0.0) {
        found.push_back(from);
      }
      from = to;
      a = b;
    };
    for (const double extreme : roots) look_until(extreme);
    look_until(piece.duration);
    roots = found;
    slope = polynomial;
  }
  return roots;
}

}  // namespace armlet
