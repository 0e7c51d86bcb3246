#include "armlet/trajectory/drawing_times.hpp"

#include <algorithm>
#include <cmath>

namespace armlet {

std::vector<double> drawing_times(const Trajectory& motion, int even) {
  constexpr std::size_t kMostKnots = 2000;
  const double T = motion.duration();
  if (T <= 0.0) return {0.0};
  const std::vector<double> knots = motion.knots();
  const bool all_knots = knots.size() <= kMostKnots;
  const int count = all_knots ? std::max(even, 2) : 4000;
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(T * k / (count - 1));
  times.back() = T;
  for (const double knot : knots) {
    if (!all_knots || knot <= 0.0 || knot >= T) continue;
    times.push_back(std::nextafter(knot, 0.0));
    times.push_back(knot);
  }
  std::ranges::sort(times);
  // clang 14 cannot compile std::ranges::unique of g++ 12.
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace armlet
