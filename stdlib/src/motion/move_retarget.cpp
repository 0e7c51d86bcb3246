#include "motion/move_retarget.hpp"

#include "armlet/trajectory/jerk_limited.hpp"
#include "motion/move_failures.hpp"
#include "motion/move_waiting.hpp"
#include "trajectory/trajectories.hpp"

namespace armlet::bind {

bool takes_over(Vm& vm, const MoveCall& call, std::string_view planner,
                const MoveSettings& settings) {
  const Cell& cell = Host::of(vm).cell();
  return cell.is_moving(call.robot) && cell.can_drive(call.robot) && !settings.time &&
         !call.classic && (planner == "Syn" || planner == "SCurve");
}

Started move_on_from_speed(Vm& vm, MoveCall call, const Eigen::VectorXd& q, double speed) {
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  const Robot& robot = model_of(vm, call);
  if (const auto outside = limit_violations(robot, q); !outside.empty())
    return fail_outside(vm, call, q, outside.front());
  std::vector<AxisLimits> limits = axis_limits(robot);
  std::vector<AxisState> from;
  for (int i = 0; i < robot.n(); ++i) {
    limits[static_cast<std::size_t>(i)].speed *= speed;
    from.push_back({.q = state.q[i], .v = state.qd[i], .a = state.qdd[i]});
  }
  std::vector<JerkProfile> profiles(from.size());
  const std::span<const double> to(q.data(), static_cast<std::size_t>(q.size()));
  const double duration = plan_jerk_limited(from, to, limits, profiles);
  MotionPlan plan = verify(robot, jerk_trajectory(from, to, profiles, duration));
  if (!plan.outside.empty()) return fail_swings_outside(vm, call, plan.outside.front());
  if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
  const double length = path_between_ends(vm, call, *plan.trajectory);
  call.fixed_time = true;  // it begins with a speed
  return start_motion(vm, call, *std::move(plan.trajectory), length);
}

}  // namespace armlet::bind
