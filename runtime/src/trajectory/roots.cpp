#include "trajectory/roots.hpp"

namespace armlet {
namespace {

// Halves the interval until no double lies between its ends; value(lo) and value(hi) differ in
// sign.
double bisect(const Segment& piece, int order, double lo, double hi) {
  const bool rising = piece.value(lo, order) < 0.0;
  for (;;) {
    const double mid = 0.5 * (lo + hi);
    if (mid <= lo || mid >= hi) return mid;
    ((piece.value(mid, order) < 0.0) == rising ? lo : hi) = mid;
  }
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
      roots.push_back(bisect(piece, order, grid[k], grid[k + 1]));
    } else if (a == 0.0 && grid[k] > 0.0) {
      roots.push_back(grid[k]);
    }
  }
  return roots;
}

}  // namespace armlet
