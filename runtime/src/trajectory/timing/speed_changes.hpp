#pragma once

#include <span>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/path_warp.hpp"

namespace armlet {

// The time in which a joint reaches its highest acceleration, or its highest speed if that is
// sooner; the longest over all joints.
double time_of_jerk(std::span<const AxisLimits> limits);

// The path parameter for a motion of limited jerk, whose ends are as long as the ramps of the
// fastest motion plus the length that jerk limits add.
PathWarp warp_of(const SpeedAlongPath& fastest, double jerk_time);

// The intervals of the fastest motion in which its speed changes, or would change if jerk were
// limited.
struct SpeedChanges {
  std::vector<double> t;  // of the positions
  std::vector<bool> busy;
};
SpeedChanges changes_of(const SpeedAlongPath& fastest, double jerk_time);

}  // namespace armlet
