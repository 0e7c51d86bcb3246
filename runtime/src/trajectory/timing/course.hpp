// A path with its limits.
#pragma once

#include <optional>
#include <span>

#include "armlet/trajectory/time_optimal.hpp"

namespace armlet {

// A path, its limits and those of its zones; and the arm whose motors limit it too, null: none.
//
// share  part of the motors' limits that is left for the motion after gravity and dry friction;
//        used only with limited jerk.
struct Course {
  const Trajectory& path;
  std::span<const AxisLimits> limits;
  std::span<const SpeedZone> zones;
  std::span<const Segment> travel;
  const Robot* arm = nullptr;
  double share = 1.0;
};

// The public function of that name, with motors too. Nothing if they cannot hold the arm somewhere.
std::optional<SpeedAlongPath> fastest_along(const Course& course, int intervals);

}  // namespace armlet
