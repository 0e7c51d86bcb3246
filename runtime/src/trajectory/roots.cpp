#include "trajectory/roots.hpp"

#include <cmath>

namespace armlet {
namespace {

// Newton's method kept inside [lo, hi], where the derivative of this order changes sign and is
// monotone; halving takes over where a step would leave the interval.
//
// source  W. H. Press et al., Numerical Recipes, 3rd ed., 2007, section 9.4.
double root_between(const Segment& piece, int order, double lo, double hi) {
  const bool rising = piece.value(lo, order) < 0.0;
  constexpr int kMostSteps = 200;  // far more than halving alone would take
  double u = 0.5 * (lo + hi);
  for (int k = 0; k < kMostSteps; ++k) {
    const double value = piece.value(u, order);
    ((value < 0.0) == rising ? lo : hi) = u;
    double next = u - value / piece.value(u, order + 1);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - u) <= 1e-15 * piece.duration) return next;
    u = next;
  }
  return u;
}

}  // namespace

std::vector<double> sign_changes(const Segment& piece, int order) {
  if (order > piece.degree) return {};
  // Between neighbouring extremes a polynomial is monotone, so it has at most one root there.
  std::vector<double> grid = sign_changes(piece, order + 1);
  grid.insert(grid.begin(), 0.0);
  grid.push_back(piece.duration);
  std::vector<double> roots;
  for (size_t k = 0; k + 1 < grid.size(); ++k) {
    const double a = piece.value(grid[k], order);
    const double b = piece.value(grid[k + 1], order);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
      roots.push_back(root_between(piece, order, grid[k], grid[k + 1]));
    } else if (a == 0.0 && grid[k] > 0.0) {
      roots.push_back(grid[k]);
    }
  }
  return roots;
}

}  // namespace armlet
