// Lines and arcs of the tool, exactly, slowly or damped where joint speeds would be high.

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "armlet/trajectory/damped_line.hpp"
#include "control/planning.hpp"

namespace armlet::control {
namespace {

using Via = std::optional<Eigen::Vector3d>;

// A path of the tool as it was planned, and the largest deviation of the tool from it, m and rad.
struct TrackedLine {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  double length = 0.0;
  double deviation = 0.0;
  double turn = 0.0;
};

TrackedLine exactly(LinePlan plan) {
  return {.motion = std::move(plan.motion), .fault = std::move(plan.fault), .length = plan.length};
}

// The same path as a path of one move, which slows down only where a limit requires it.
TrackedLine slowly(const Robot& robot, const LineMove& move, const Via& p_world_via,
                   bool only_position) {
  PathMove path{.q0 = move.q0,
                .points = {{.T_world_tool = move.T_world_goal,
                            .p_world_via = p_world_via,
                            .tool_speed = move.tool_speed,
                            .tool_accel = move.tool_accel}},
                .time = move.time,
                .jerk = Jerk::kFree};
  if (!move.time && !move.tool_speed) path.speed = move.speed;
  PathPlan plan = plan_path(robot, path);
  if (plan.fault && only_position) {
    path.task = IkTask::kPositionFirst;
    plan = plan_path(robot, path);
  }
  return {.motion = std::move(plan.motion), .fault = std::move(plan.fault), .length = plan.length};
}

TrackedLine damped(const Robot& robot, LineMove move, const Via& p_world_via, bool only_position) {
  // Arms that cannot rotate their tool freely follow only the position.
  move.task = only_position && robot.n() < 6 ? IkTask::kPositionFirst : IkTask::kPose;
  const std::optional<DampedLine> plan =
      p_world_via ? plan_damped_arc(robot, *p_world_via, move) : plan_damped_line(robot, move);
  if (!plan) {
    const auto why = no_circle_over(forward(robot, move.q0).translation(), *p_world_via,
                                    move.T_world_goal.translation());
    return {.fault = LineFault{.kind = LineFaultKind::kNoArc,
                               .T_world_tool = move.T_world_goal,
                               .no_circle = why.value_or(NoCircle::kOnOneLine)}};
  }
  return {.motion = plan->motion,
          .length = plan->length,
          .deviation = plan->deviation,
          .turn = plan->angle};
}

// The path to move.T_world_goal, straight or on an arc over a position. For kSlow and kDamped the
// goal is a whole pose that can be reached; `only_position`: the target has no orientation.
TrackedLine tracked(const Robot& robot, const LineMove& move, const Via& p_world_via, Track track,
                    bool only_position) {
  switch (track) {
    case Track::kSlow:
      return slowly(robot, move, p_world_via, only_position);
    case Track::kDamped:
      return damped(robot, move, p_world_via, only_position);
    default:
      return exactly(p_world_via ? plan_arc(robot, *p_world_via, move) : plan_line(robot, move));
  }
}

// Plans the line, slower or within wider limits if the policies say so.
TrackedLine within_policies(Planning& p, LineMove move, const LineTarget& target) {
  const auto plan_it = [&] {
    return tracked(p.model(), move, target.p_world_via, p.policies().track,
                   !target.pose.has_orientation);
  };
  TrackedLine line = plan_it();
  const bool leaves = line.fault || !line.motion.outside.empty();
  if (leaves && lift_limits(p)) {
    TrackedLine beyond = plan_it();
    if (beyond.motion.ok()) return beyond;
  }
  if (!line.fault && !line.motion.ok() && line.motion.too_fast && move.time) {
    if (const auto time = lengthened(p, *line.motion.too_fast)) {
      move.time = time;
      line = plan_it();
    }
  }
  return line;
}

// The times of the command that no joint has to be asked about.
bool check_times(Planning& p, const LineTarget& target, double distance) {
  const std::optional<double>& time = p.command.time;
  if (time && *time == 0.0 && distance > 0.0) return p.refuse(refused::NoTime{distance});
  if (time) return true;
  const double least = least_time(distance, target.tool_speed, target.tool_accel);
  return check_time_left(
      p, least, target.tool_speed ? refused::Lasts::kSpeed : refused::Lasts::kAcceleration);
}

bool take(Planning& p, TrackedLine line, const LineMove& move, const ToolPose& pose) {
  if (line.fault) {
    return p.refuse(refused::LineBlocked{*std::move(line.fault), move.q0, pose});
  }
  if (!line.motion.outside.empty()) {
    return p.refuse(
        refused::OutsideLimits{line.motion.outside.front(), refused::Where::kTarget, move.q0});
  }
  if (!line.motion.trajectory) return p.refuse(*line.motion.too_fast);
  if (line.motion.too_fast) p.report.limits.too_fast.push_back(*line.motion.too_fast);
  PlannedMove& planned = p.report.planned;
  planned.motion = std::move(line.motion.trajectory);
  planned.length = line.length;
  planned.deviation = line.deviation;
  planned.turn = line.turn;
  return true;
}

}  // namespace

bool plan(Planning& p, const LineTarget& target) try {
  if (!prepare(p, Needs::kToolPoint)) return false;
  const Eigen::VectorXd& q0 = p.state().q;
  const std::optional<IkTask> task = task_of(p.model(), target.pose);
  if (!task) return p.refuse(refused::Tilted{target.pose});
  const Eigen::Isometry3d T_world_tool = forward(p.model(), q0);
  const Eigen::Isometry3d& T_world_goal = target.pose.T_world_tool;
  const double distance = (T_world_goal.translation() - T_world_tool.translation()).norm();
  if (!check_times(p, target, distance)) return false;
  LineMove move{.q0 = q0,
                .T_world_goal = T_world_goal,
                .task = *task,
                .time = p.command.time,
                .tool_speed = target.tool_speed,
                .tool_accel = target.tool_accel,
                .speed = p.command.speed.value_or(1.0),
                .enforce_limits = !p.policies().may_be_too_fast()};
  if (p.policies().track != Track::kExact) {
    SolvedGoal goal = goal_after(p.model(), target.pose, {T_world_tool, q0}, p.policies().limits);
    if (!goal.ok()) return p.refuse(*std::move(goal.refusal));
    move.T_world_goal = goal.T_world_tool;
  }
  return take(p, within_policies(p, move, target), move, target.pose);
} catch (const ArgumentError& error) {
  return p.refuse(refused::Invalid{error.what()});
}

}  // namespace armlet::control
