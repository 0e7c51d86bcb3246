#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/path_warp.hpp"

namespace armlet {

// How long a joint needs to come to its highest acceleration, or to its highest speed if that is
// less; the longest of all.
double time_of_jerk(std::span<const AxisLimits> limits);

// The parameter for a run with limited jerk, whose ends are as long as the ramps of the fastest run
// and as what the limits on jerk add to them.
PathWarp warp_of(const SpeedAlongPath& fastest, double jerk_time);

// The intervals of the fastest run in which its speed changes, or would change if jerk were
// limited.
struct SpeedChanges {
  std::vector<double> t;  // of the positions
  std::vector<bool> busy;
};
SpeedChanges changes_of(const SpeedAlongPath& fastest, double jerk_time);

}  // namespace armlet
