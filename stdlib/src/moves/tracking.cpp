#include "moves/tracking.hpp"

#include <utility>

#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "armlet/trajectory/damped_line.hpp"

namespace armlet::bind {
namespace {

TrackedLine exactly(LinePlan plan) {
  return {.motion = std::move(plan.motion), .fault = std::move(plan.fault), .length = plan.length};
}

// The line as a path of one move, which slows down only where a limit requires it.
TrackedLine slowly(const Robot& robot, const LineMove& move,
                   const std::optional<Eigen::Vector3d>& p_world_via, bool only_position) {
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

TrackedLine damped(const Robot& robot, LineMove move,
                   const std::optional<Eigen::Vector3d>& p_world_via, bool only_position) {
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

}  // namespace

TrackedLine plan_tracked(const Robot& robot, const LineMove& move,
                         const std::optional<Eigen::Vector3d>& p_world_via, Track track,
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

}  // namespace armlet::bind
