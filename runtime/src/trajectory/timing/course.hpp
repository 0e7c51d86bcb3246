// What is run along, and what limits it.
#pragma once

#include <optional>
#include <span>

#include "armlet/trajectory/time_optimal.hpp"

namespace armlet {

// A path, its limits and those of its zones; and the arm whose motors limit it too, null: none.
//
// share  of what gravity and dry friction leave of the motors' limits, that motion may take; only
//        where the jerk is limited.
struct Course {
  const Trajectory& path;
  std::span<const AxisLimits> limits;
  std::span<const SpeedZone> zones;
  std::span<const Segment> travel;
  const Robot* arm = nullptr;
  double share = 1.0;
};

// As the public function of that name, with motors too. Nothing if they cannot hold the arm
// somewhere.
std::optional<SpeedAlongPath> fastest_along(const Course& course, int intervals);

}  // namespace armlet
