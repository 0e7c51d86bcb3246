// Moves of the joints: straight, around obstacles, and from the speed after a velocity command.

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/jerk_limited.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "control/planning.hpp"

namespace armlet::control {
namespace {

using Eigen::VectorXd;

// The joint values that reach the goal: the given ones first, then other solutions, nearest first.
std::vector<VectorXd> goals_of(const Robot& robot, const VectorXd& q0, const VectorXd& q,
                               bool any_branch) {
  constexpr double kSame = 1e-6;
  std::vector<VectorXd> goals = {q};
  if (!any_branch) return goals;
  for (VectorXd& other : solve_ik_all(robot, forward(robot, q), {.seed = q0})) {
    const bool known = std::ranges::any_of(
        goals, [&](const VectorXd& each) { return (each - other).cwiseAbs().maxCoeff() < kSame; });
    if (!known) goals.push_back(std::move(other));
  }
  return goals;
}

// Moves from the present speeds to rest at q within limits on speed, acceleration and jerk.
bool plan_from_speed(Planning& p, const VectorXd& q) {
  const CellRobot& state = p.state();
  const Robot& robot = p.model();
  if (const auto outside = limit_violations(robot, q); !outside.empty())
    return p.refuse(refused::OutsideLimits{outside.front(), refused::Where::kTarget, q});
  std::vector<AxisLimits> limits = axis_limits(robot);
  std::vector<AxisState> from;
  for (int i = 0; i < robot.n(); ++i) {
    limits[static_cast<std::size_t>(i)].speed *= p.command.speed.value_or(1.0);
    from.push_back({.q = state.q[i], .v = state.qd[i], .a = state.qdd[i]});
  }
  std::vector<JerkProfile> profiles(from.size());
  const std::span<const double> to(q.data(), static_cast<std::size_t>(q.size()));
  const double duration = plan_jerk_limited(from, to, limits, profiles);
  MotionPlan plan = verify(robot, jerk_trajectory(from, to, profiles, duration));
  if (!plan.outside.empty())
    return p.refuse(refused::OutsideLimits{plan.outside.front(), refused::Where::kBetween});
  if (!plan.trajectory) return p.refuse(*plan.too_fast);
  p.report.planned.length = between_ends(robot, *plan.trajectory);
  p.report.planned.motion = std::move(plan.trajectory);
  p.fixed_time = true;
  return true;
}

// The straight motion, in a longer time if the policies say so.
MotionPlan plan_straight(Planning& p, const VectorXd& q) {
  JointMove move{.q0 = p.state().q,
                 .q1 = q,
                 .planner = p.command.planner,
                 .time = p.command.time,
                 .speed = p.command.speed,
                 .enforce_limits = !p.policies().may_be_too_fast(),
                 .motors = p.motors()};
  MotionPlan plan = plan_joint_move(p.planners, p.model(), move);
  if (plan.trajectory || !plan.too_fast) return plan;
  const auto time = lengthened(p, *plan.too_fast);
  if (!time) return plan;
  move.time = time;
  return plan_joint_move(p.planners, p.model(), move);
}

// The motion around obstacles, or the reason why there is none.
bool take(Planning& p, WayAround around, std::size_t goals) {
  if (!around.way.ok()) return p.refuse(refused::NoWayAround{std::move(around), goals});
  if (!around.ok()) {
    if (!around.met.empty()) return p.refuse(refused::Collides{around.met.front(), 0.0});
    if (!around.motion.outside.empty()) {
      return p.refuse(
          refused::OutsideLimits{around.motion.outside.front(), refused::Where::kBetween});
    }
    return p.refuse(*around.motion.too_fast);
  }
  PlannedMove& planned = p.report.planned;
  const auto& points = around.way.points;
  for (std::size_t k = 1; k < points.size(); ++k)
    planned.T_world_targets.push_back(forward(p.model(), points[k]));
  planned.times = std::move(around.times);
  planned.length = around.length;
  planned.motion = std::move(around.motion.trajectory);
  p.report.around = planned.motion;
  return true;
}

bool plan_joints(Planning& p, const VectorXd& q, bool any_branch) {
  const CellRobot& state = p.state();
  if (q.size() == state.model->n() && !limit_violations(*state.model, q).empty()) lift_limits(p, q);
  if (q.size() != p.model().n())
    return p.refuse(refused::WrongJointCount{static_cast<int>(q.size())});
  if (!check_speed(p)) return false;
  if (!p.planners.has(p.command.planner))
    return p.refuse(refused::UnknownPlanner{p.command.planner});
  if (p.cell.is_moving(p.command.robot)) return plan_from_speed(p, q);
  MotionPlan plan = plan_straight(p, q);
  if (!plan.outside.empty())
    return p.refuse(refused::OutsideLimits{plan.outside.front(), refused::Where::kTarget, q});
  if (!plan.trajectory) return p.refuse(*plan.too_fast);
  if (plan.too_fast) p.report.limits.too_fast.push_back(*plan.too_fast);
  if (!starts_and_stops(*plan.trajectory)) return p.refuse(refused::SpeedJumps{p.command.planner});
  // Fingers have a prescribed path: no other path is searched, and a collision is refused.
  if (p.policies().avoid && state.on < 0 &&
      !find_collisions(p.cell, p.command.robot, *plan.trajectory).empty())
    return go_around(p, q, any_branch, {});
  p.report.planned.length = between_ends(p.model(), *plan.trajectory);
  p.report.planned.motion = std::move(plan.trajectory);
  return true;
}

}  // namespace

bool go_around(Planning& p, const VectorXd& q, bool any_branch, const WayOptions& search) try {
  WayAroundRequest request{.robot = p.command.robot,
                           .goals = goals_of(p.model(), p.state().q, q, any_branch),
                           .model = p.report.planned.model,
                           .time = p.command.time,
                           .search = search};
  if (!request.time) request.speed = p.command.speed.value_or(1.0);
  const std::size_t goals = request.goals.size();
  const auto find_it = [&] { return find_way_around(p.cell, request); };
  WayAround around = find_it();
  keep_time(p, request.time, around, find_it);
  return take(p, std::move(around), goals);
} catch (const ArgumentError& error) {
  return p.refuse(refused::Invalid{error.what()});
}

bool plan(Planning& p, const JointTarget& target) {
  const Robot& robot = *p.state().model;
  VectorXd q = target.q;
  if (p.policies().limits == LimitCheck::kClamp && q.size() == robot.n() && q.allFinite()) {
    p.report.limits.clamped = limit_violations(robot, q);
    for (const LimitViolation& each : p.report.limits.clamped) q[each.joint] = each.limit;
  }
  return prepare(p, Needs::kJoints) && plan_joints(p, q, target.any_branch);
}

bool plan(Planning& p, const PoseTarget& target) {
  if (!prepare(p, Needs::kJoints)) return false;
  if (p.state().on >= 0) return p.refuse(refused::NoToolPoint{});
  const bool is_near = target.near.size() > 0;
  SolvedGoal goal =
      solve_goal(p.model(), target.pose, is_near ? target.near : p.state().q, p.policies().limits);
  if (!goal.ok()) return p.refuse(*std::move(goal.refusal));
  return plan_joints(p, goal.q, !is_near);
}

}  // namespace armlet::control
