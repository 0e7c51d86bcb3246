// Several targets as one motion: smooth curves, and paths with rounded corners.

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "control/planning.hpp"

namespace armlet::control {
namespace {

using Eigen::VectorXd;

// The goals of several targets one after another, each with the joint values at which its move
// begins.
struct Corners {
  SolvedGoal at{};
  std::vector<VectorXd> starts{};

  // False: this goal cannot be reached; the report names it.
  bool add(Planning& p, SolvedGoal goal) {
    if (!goal.ok()) {
      p.report.target = static_cast<int>(starts.size());
      return p.refuse(*std::move(goal.refusal));
    }
    starts.push_back(at.q);
    at = std::move(goal);
    return true;
  }
};

bool take(Planning& p, PathPlan plan, const Corners& corners,
          std::vector<Eigen::Isometry3d> poses) {
  if (plan.fault) {
    const auto k = static_cast<std::size_t>(plan.point);
    p.report.target = plan.point;
    return p.refuse(refused::LineBlocked{*std::move(plan.fault), corners.starts[k], {poses[k]}});
  }
  if (!plan.motion.outside.empty())
    return p.refuse(refused::OutsideLimits{plan.motion.outside[0], refused::Where::kBetween});
  if (!plan.ok()) return p.refuse(*plan.motion.too_fast);
  PlannedMove& planned = p.report.planned;
  planned.motion = std::move(plan.motion.trajectory);
  planned.length = plan.length;
  planned.times = std::move(plan.times);
  planned.missed = std::move(plan.missed);
  planned.T_world_targets = std::move(poses);
  return true;
}

// Plans again with wider limits or in another time, if the policies say so.
template <class PlanIt>
PathPlan within_policies(Planning& p, PathPlan plan, std::optional<double>& time,
                         const PlanIt& plan_it) {
  if (!plan.ok() && !plan.motion.too_fast && lift_limits(p)) {
    PathPlan beyond = plan_it();
    if (!beyond.fault) plan = std::move(beyond);
  }
  keep_time(p, time, plan, plan_it);
  return plan;
}

PathPlan curve_plan(const Robot& robot, SplineMove move, bool only_positions) {
  PathPlan plan = plan_cartesian_spline(robot, move);
  if (!plan.fault || !only_positions) return plan;
  // The orientation cannot be kept everywhere: the tool rotates as little as necessary.
  move.task = IkTask::kPositionFirst;
  return plan_cartesian_spline(robot, move);
}

// The goal of a move of a path.
SolvedGoal goal_of(const Planning& p, const PathStep& step, const SolvedGoal& at) {
  const Robot& robot = p.model();
  if (!step.moves_joints) return goal_after(robot, step.pose, at, p.policies().limits);
  SolvedGoal goal;
  if (step.q) {
    goal.q = *step.q;
  } else {
    goal =
        solve_goal(robot, step.pose, step.near.size() > 0 ? step.near : at.q, p.policies().limits);
  }
  if (!goal.ok()) return goal;
  if (goal.q.size() != robot.n())
    return {.refusal = refused::WrongJointCount{static_cast<int>(goal.q.size())}};
  const auto outside = limit_violations(robot, goal.q);
  if (!outside.empty() && p.policies().limits != LimitCheck::kWarn)
    return {.refusal = refused::OutsideLimits{outside.front(), refused::Where::kTarget, goal.q}};
  goal.T_world_tool = forward(robot, goal.q);
  return goal;
}

// A lower bound of the duration of the moves with speeds of their own, s.
double slowest(const Robot& robot, const PathMove& move) {
  double time = 0.0;
  Eigen::Vector3d from = forward(robot, move.q0).translation();
  for (const PathPoint& point : move.points) {
    const Eigen::Vector3d to = point.T_world_tool.translation();
    time += least_time((to - from).norm(), point.tool_speed, point.tool_accel);
    from = to;
  }
  return time;
}

}  // namespace

bool plan(Planning& p, const CurveTarget& target) {
  if (!prepare(p, Needs::kJoints)) return false;
  const VectorXd& q0 = p.state().q;
  SplineMove move{.q0 = q0, .kind = target.kind, .time = p.command.time};
  if (!move.time) move.speed = p.command.speed.value_or(1.0);
  Corners corners{.at = {forward(p.model(), q0), q0}};
  for (const ToolPose& pose : target.poses) {
    if (p.state().on >= 0) return p.refuse(refused::NoToolPoint{});
    if (!corners.add(p, goal_after(p.model(), pose, corners.at, p.policies().limits))) return false;
    move.poses.push_back(corners.at.T_world_tool);
  }
  const bool only_positions =
      std::ranges::none_of(target.poses, [](const ToolPose& pose) { return pose.has_orientation; });
  const auto plan_it = [&] { return curve_plan(p.model(), move, only_positions); };
  return take(p, within_policies(p, plan_it(), move.time, plan_it), corners, move.poses);
}

bool plan(Planning& p, const PathTarget& target) try {
  if (!prepare(p, Needs::kJoints)) return false;
  const VectorXd& q0 = p.state().q;
  Corners corners{.at = {forward(p.model(), q0), q0}};
  PathMove move{.q0 = q0, .time = p.command.time};
  if (!move.time) move.speed = p.command.speed.value_or(1.0);
  std::vector<Eigen::Isometry3d> poses;
  for (const PathStep& step : target.steps) {
    if (p.state().on >= 0 && !step.q) return p.refuse(refused::NoToolPoint{});
    if (!corners.add(p, goal_of(p, step, corners.at))) return false;
    poses.push_back(corners.at.T_world_tool);
    move.points.push_back({.T_world_tool = corners.at.T_world_tool,
                           .q = step.moves_joints ? std::optional(corners.at.q) : std::nullopt,
                           .p_world_via = step.p_world_via,
                           .blend = step.blend,
                           .tool_speed = step.tool_speed,
                           .tool_accel = step.tool_accel});
  }
  if (p.policies().track == Track::kSlow) move.jerk = Jerk::kFree;
  if (move.jerk == Jerk::kLimited) move.motors = p.motors();
  if (!check_time_left(p, slowest(p.model(), move), refused::Lasts::kMotion)) return false;
  const auto plan_it = [&] { return plan_path(p.model(), move); };
  PathPlan first = plan_it();
  const bool only_positions = std::ranges::none_of(target.steps, [](const PathStep& step) {
    return step.pose.has_orientation && !step.moves_joints;
  });
  if (first.fault && only_positions) {
    // The orientation cannot be kept everywhere: the tool rotates as little as necessary.
    move.task = IkTask::kPositionFirst;
    first = plan_it();
  }
  return take(p, within_policies(p, std::move(first), move.time, plan_it), corners,
              std::move(poses));
} catch (const ArgumentError& error) {
  return p.refuse(refused::Invalid{error.what()});
}

}  // namespace armlet::control
