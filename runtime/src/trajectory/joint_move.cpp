#include "armlet/trajectory/joint_move.hpp"

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {

MotionPlan plan_joint_move(const PlannerSet& planners, const Robot& robot, const JointMove& move) {
  check_size("q0", move.q0.size(), robot.n());
  check_size("q1", move.q1.size(), robot.n());
  check_finite("q1", move.q1);
  // A target out of range is reported first, even if the time is too short as well.
  if (auto outside = limit_violations(robot, move.q1); !outside.empty()) {
    return {.outside = std::move(outside)};
  }
  Plan plan = planners.plan(move.planner, {.q0 = move.q0,
                                           .q1 = move.q1,
                                           .limits = axis_limits(robot),
                                           .time = move.time,
                                           .speed = move.speed,
                                           .enforce_limits = move.enforce_limits,
                                           .motors = move.motors});
  if (!plan.trajectory) return {.too_fast = plan.too_fast};
  MotionPlan verified =
      verify(robot, *std::move(plan.trajectory), move.enforce_limits, Jerk::kFree, move.motors);
  // A planner computes the least time of its own law; verification computes that of this path.
  if (plan.too_fast) verified.too_fast = plan.too_fast;
  return verified;
}

}  // namespace armlet
