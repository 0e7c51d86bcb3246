#pragma once

#include <functional>
#include <optional>

#include "armlet/trajectory/cartesian_line.hpp"
#include "trajectory/tool/pose_curve.hpp"

namespace armlet {

// The curve between two poses; nothing if there is none.
using CurveMaker = std::function<std::optional<CurvePiece>(const Eigen::Isometry3d& T_start,
                                                           const Eigen::Isometry3d& T_end)>;

// The common part of plan_line and plan_arc: the goal, the curve to it, its samples, the time.
LinePlan plan_curve(const Robot& robot, const LineMove& move, const CurveMaker& make);

// Throws ArgumentError for what plan_line refuses.
void check_line_move(const Robot& robot, const LineMove& move);

// A motion of one second, executed in the time of the move, and verified.
MotionPlan run_unit_motion(const Robot& robot, const LineMove& move, const Trajectory& unit,
                           double length, Jerk jerk);

}  // namespace armlet
