#include "armlet/trajectory/cartesian_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"
#include "trajectory/tool/curve_plan.hpp"
#include "trajectory/tool/line_samples.hpp"

namespace armlet {
namespace {

constexpr double kQuinticPeak = 1.875;  // peak speed of the quintic law, times T / length
// Its peak acceleration, times T^2 / length: 10 / sqrt(3).
constexpr double kQuinticAccelPeak = 5.773502691896258;
constexpr double kShortest = 1e-9;        // s, resolution of the clock
constexpr double kGoalTolerance = 1e-10;  // m and rad, tried before the solver's usual ones

}  // namespace

void check_line_move(const Robot& robot, const LineMove& move) {
  check_size("q0", move.q0.size(), robot.n());
  check_finite("q0", move.q0);
  check_pose("T_world_goal", move.T_world_goal);
  if (move.time && (!std::isfinite(*move.time) || *move.time < 0.0)) {
    throw ArgumentError(
        fmt::format("The time of a move is {} s; expected 0 s or more.", *move.time));
  }
  if (move.tool_speed) check_positive("tool_speed", *move.tool_speed);
  if (move.tool_accel) check_positive("tool_accel", *move.tool_accel);
  if (!(move.speed > 0.0 && move.speed <= 1.0)) {
    throw ArgumentError(
        fmt::format("The speed of a move is {}; expected a fraction of the joint limits, above 0 "
                    "and at most 1.",
                    move.speed));
  }
  if (move.time && move.tool_speed) {
    throw ArgumentError("A move was given both a time and a speed; give one of them.");
  }
}

namespace {

IkResult solve_goal(const Robot& robot, const LineMove& move) {
  IkOptions options{.seed = move.q0, .task = move.task, .diagnose = false};
  options.position_tolerance = kGoalTolerance;
  options.rotation_tolerance = kGoalTolerance;
  IkResult exact = solve_ik(robot, move.T_world_goal, options);
  if (exact.ok()) return exact;
  return solve_ik(robot, move.T_world_goal, {.seed = move.q0, .task = move.task});
}

// The pose at the end of the line. If the task leaves the orientation free, it is that of the
// solution; for a position alone no solution is needed.
Eigen::Isometry3d line_end(const Robot& robot, const LineMove& move, const IkResult& goal) {
  if (move.task == IkTask::kPositionFirst || move.task == IkTask::kPosition)
    return move.T_world_goal;
  return forward(robot, goal.q);
}

bool nothing_to_do(const Robot& robot, const LineMove& move, const Eigen::Isometry3d& T_world_end) {
  const Eigen::Isometry3d T_world_start = forward(robot, move.q0);
  const bool oriented = move.task != IkTask::kPositionFirst && move.task != IkTask::kPosition;
  return (T_world_end.translation() - T_world_start.translation()).norm() < 1e-9 &&
         (!oriented || angle_between(T_world_start, T_world_end) < 1e-9);
}

// The requested duration, or the shortest within the limits of the tool and of the joints.
double duration(const LineMove& move, double by_joints, double length) {
  if (move.time) return *move.time;
  double by_tool = 0.0;
  if (move.tool_speed) by_tool = kQuinticPeak * length / *move.tool_speed;
  if (move.tool_accel)
    by_tool = std::max(by_tool, std::sqrt(kQuinticAccelPeak * length / *move.tool_accel));
  if (!move.tool_speed) return std::max(by_tool, by_joints / move.speed);
  return std::max(by_tool, move.enforce_limits || length == 0.0 ? by_joints : 0.0);
}

}  // namespace

MotionPlan run_unit_motion(const Robot& robot, const LineMove& move, const Trajectory& unit,
                           double length, Jerk jerk) {
  const TooFast least = least_time(robot, unit, jerk);
  const double T = duration(move, least.least_time, length);
  if (T >= kShortest) return verify(robot, unit.stretched(T), move.enforce_limits, jerk);
  MotionPlan refused{.too_fast = least};
  refused.too_fast->given = T;
  return refused;
}

LinePlan plan_curve(const Robot& robot, const LineMove& move, const CurveMaker& make) {
  check_line_move(robot, move);
  LinePlan plan;
  IkResult goal = solve_goal(robot, move);
  if (!goal.ok()) {
    plan.fault = {.kind = LineFaultKind::kGoal,
                  .fraction = 0.0,
                  .T_world_tool = move.T_world_goal,
                  .ik = std::move(goal)};
    return plan;
  }
  const Eigen::Isometry3d T_world_end = line_end(robot, move, goal);
  const std::optional<CurvePiece> piece = make(forward(robot, move.q0), T_world_end);
  if (!piece) {
    plan.fault = {.kind = LineFaultKind::kNoArc, .T_world_tool = move.T_world_goal};
    return plan;
  }
  plan.length = piece->travel();
  if (!piece->is_round() && nothing_to_do(robot, move, T_world_end)) {
    plan.motion = verify(robot, Trajectory::at_rest(move.q0, move.time.value_or(0.0)));
    return plan;
  }
  // If the goal determines the whole orientation, samples have to match it, also for a rotation
  // about z.
  const IkTask task = move.task == IkTask::kHeading ? IkTask::kPose : move.task;
  PoseCurve curve;
  curve.add(*piece);
  LineSamples samples(robot, move.q0, std::move(curve), task);
  if (!samples.follow()) {
    plan.fault = samples.fault();
    return plan;
  }
  plan.motion = run_unit_motion(robot, move, samples.motion(), plan.length, Jerk::kLimited);
  return plan;
}

LinePlan plan_line(const Robot& robot, const LineMove& move) {
  return plan_curve(robot, move, straight_piece);
}

}  // namespace armlet
