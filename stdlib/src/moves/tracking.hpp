#pragma once
// How lines and arcs are tracked where joint speeds would be high (`with (track: ...)`).

#include <optional>

#include "armlet/trajectory/cartesian_line.hpp"
#include "values/settings.hpp"

namespace armlet::bind {

// A path of the tool as it was planned.
//
// deviation, turn  largest deviation of the tool from it, m and rad.
struct TrackedLine {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  double length = 0.0;
  double deviation = 0.0;
  double turn = 0.0;
};

// The path to move.T_world_goal, straight or on an arc over a position. For kSlow and kDamped the
// goal is a whole pose that can be reached; `only_position`: the target has no orientation.
[[nodiscard]] TrackedLine plan_tracked(const Robot& robot, const LineMove& move,
                                       const std::optional<Eigen::Vector3d>& p_world_via,
                                       Track track, bool only_position);

}  // namespace armlet::bind
