#pragma once

#include <functional>
#include <optional>

#include "armlet/trajectory/cartesian_line.hpp"
#include "trajectory/pose_curve.hpp"

namespace armlet {

// The curve between two poses; nothing if there is none.
using CurveMaker = std::function<std::optional<CurvePiece>(const Eigen::Isometry3d& T_start,
                                                           const Eigen::Isometry3d& T_end)>;

// What plan_line and plan_arc share: the goal, the curve to it, its samples, the time.
LinePlan plan_curve(const Robot& robot, const LineMove& move, const CurveMaker& make);

}  // namespace armlet
