#include "armlet/control/tool_goals.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

constexpr double kGoalTolerance = 1e-10;  // m and rad, tried before the solver's default tolerance

// Solves with the smallest error possible.
SolvedGoal solve_exactly(const Robot& robot, const ToolPose& pose, const Eigen::VectorXd& seed,
                         LimitCheck limits) {
  if (const std::optional<IkTask> task = task_of(robot, pose)) {
    IkOptions options{.seed = seed, .task = *task, .diagnose = false};
    options.position_tolerance = kGoalTolerance;
    options.rotation_tolerance = kGoalTolerance;
    IkResult exact = solve_ik(robot, pose.T_world_tool, options);
    if (exact.ok()) return {.T_world_tool = pose.T_world_tool, .q = std::move(exact.q)};
  }
  return solve_goal(robot, pose, seed, limits);
}

}  // namespace

std::optional<IkTask> task_of(const Robot& robot, const ToolPose& pose) {
  if (!pose.has_orientation) return IkTask::kPositionFirst;
  return frame_task(robot, pose.T_world_tool);
}

SolvedGoal solve_goal(const Robot& robot, const ToolPose& pose, const Eigen::VectorXd& seed,
                      LimitCheck limits) {
  const Eigen::Isometry3d& T = pose.T_world_tool;
  const std::optional<IkTask> task = task_of(robot, pose);
  if (!task) return {.refusal = refused::Tilted{pose}};
  IkResult result = solve_ik(robot, T, {.seed = seed, .task = *task});
  if (result.status == IkStatus::kJointLimit && limits == LimitCheck::kWarn) {
    const IkResult beyond =
        solve_ik(robot, T, {.seed = seed, .task = *task, .respect_limits = false});
    if (beyond.ok()) return {.T_world_tool = T, .q = wrap_near(robot, beyond.q, seed)};
  }
  if (!result.ok()) return {.refusal = refused::Unreachable{T, std::move(result)}};
  return {.T_world_tool = T, .q = std::move(result.q)};
}

SolvedGoal goal_after(const Robot& robot, const ToolPose& pose, const SolvedGoal& before,
                      LimitCheck limits) {
  if (!pose.has_orientation) {
    const Eigen::Isometry3d kept =
        make_pose(before.T_world_tool.linear(), pose.T_world_tool.translation());
    IkResult same = solve_ik(robot, kept, {.seed = before.q, .diagnose = false});
    if (same.ok()) return {.T_world_tool = kept, .q = std::move(same.q)};
  }
  SolvedGoal goal = solve_exactly(robot, pose, before.q, limits);
  if (!goal.ok()) return goal;
  const bool is_whole = task_of(robot, pose) == IkTask::kPose;
  goal.T_world_tool = is_whole ? pose.T_world_tool : forward(robot, goal.q);
  return goal;
}

Robot with_wider_limits(const Robot& robot, const Eigen::VectorXd& q) {
  constexpr double kMoreTurns = 8.0 * kPi;  // rad, beyond the limits of a revolute joint
  constexpr double kMoreTravel = 10.0;      // m
  Eigen::VectorXd lower = robot.lower(), upper = robot.upper();
  for (int i = 0; i < robot.n(); ++i) {
    if (robot.joint(i).is_continuous()) continue;
    const double more = robot.is_revolute(i) ? kMoreTurns : kMoreTravel;
    lower[i] -= more;
    upper[i] += more;
    if (q.size() != robot.n() || !std::isfinite(q[i])) continue;
    lower[i] = std::min(lower[i], q[i] - more);
    upper[i] = std::max(upper[i], q[i] + more);
  }
  const Eigen::VectorXd home = robot.home();
  return robot.with_limits(lower, upper).with_home(home);
}

}  // namespace armlet
