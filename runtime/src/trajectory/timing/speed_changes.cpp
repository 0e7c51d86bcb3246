#include "trajectory/timing/speed_changes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace armlet {
namespace {

// of the highest acceleration along the path: a larger one is a change
constexpr double kChanges = 0.02;

// Length of the ramp at one side of the fastest motion, in which it reaches most of its first
// constant speed, plus the length that jerk limits add.
double ramp_length(const SpeedAlongPath& fastest, bool from_end, double jerk_time) {
  const std::size_t last = fastest.s.size() - 1;
  const auto at = [&](std::size_t k) { return from_end ? last - k : k; };
  std::size_t top = 0;
  while (top < last && fastest.squared[at(top + 1)] > fastest.squared[at(top)]) ++top;
  std::size_t k = 0;
  while (k < top && fastest.squared[at(k)] < 0.5 * fastest.squared[at(top)]) ++k;
  return std::abs(fastest.s[at(k)] - fastest.s[at(0)]) +
         0.5 * jerk_time * std::sqrt(fastest.squared[at(top)]);
}

}  // namespace

double time_of_jerk(std::span<const AxisLimits> limits) {
  double longest = 0.0;
  for (const AxisLimits& l : limits)
    longest = std::max(longest, std::min(l.acceleration / l.jerk, std::sqrt(l.speed / l.jerk)));
  return longest;
}

PathWarp warp_of(const SpeedAlongPath& fastest, double jerk_time) {
  const double L = fastest.s.back();
  const auto ramp = [&](bool from_end) {
    return 2.0 * std::clamp(2.0 * ramp_length(fastest, from_end, jerk_time), 1e-3 * L, 0.5 * L);
  };
  return {L, ramp(false), ramp(true)};
}

SpeedChanges changes_of(const SpeedAlongPath& fastest, double jerk_time) {
  const std::size_t count = fastest.s.size() - 1;
  SpeedChanges changes{.t = {0.0}, .busy = std::vector<bool>(count, false)};
  std::vector<double> rate(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double ds = fastest.s[k + 1] - fastest.s[k];
    const double v = std::sqrt(fastest.squared[k]) + std::sqrt(fastest.squared[k + 1]);
    changes.t.push_back(changes.t.back() + 2.0 * ds / v);
    rate[k] = std::abs(fastest.squared[k + 1] - fastest.squared[k]) / ds;
  }
  const double least = kChanges * *std::ranges::max_element(rate);
  double until = -1.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (rate[k] >= least) until = changes.t[k + 1] + jerk_time;
    changes.busy[k] = changes.t[k] <= until;
  }
  double since = 2.0 * changes.t.back();
  for (std::size_t k = count; k-- > 0;) {
    if (rate[k] >= least) since = changes.t[k] - jerk_time;
    if (changes.t[k + 1] >= since) changes.busy[k] = true;
  }
  return changes;
}

}  // namespace armlet
