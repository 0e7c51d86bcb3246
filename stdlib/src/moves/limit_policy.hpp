#pragma once
// The effect of a block `with (limits: ...)` on moves that would exceed the limits of the joints.

#include <optional>

#include "moves/move_failures.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The joint values that a move uses. If the blocks around the call say "clamp": clamped to the
// limits, with advice (W0757) that names the joint and the excess; otherwise unchanged.
//
// call  gets the joint that was farthest outside.
Eigen::VectorXd clamped(Vm& vm, MoveCall& call, const Eigen::VectorXd& q);

// If the blocks around the call say "warn": gives the call a robot with wider limits on joint
// values, which contain `q`, if it has values, and do not restrict other motions. Otherwise returns
// false: the limits hold.
bool lift_limits(Vm& vm, MoveCall& call, const Eigen::VectorXd& q = {});

// The joint that a motion takes farthest beyond the limits of the robot in the cell, with advice
// (W0758) if there is one. If the motion stays inside: the excess of its clamped target.
LimitExcess report_excess(Vm& vm, const MoveCall& call, const Trajectory& motion);

// Whether a motion that is too fast is executed nevertheless, with advice.
[[nodiscard]] bool may_be_too_fast(Vm& vm, const MoveCall& call);
// The longer time of a motion that is too fast, if the blocks say "clamp", with advice (W0759);
// otherwise nullopt.
std::optional<double> lengthened(Vm& vm, const MoveCall& call, const TooFast& fast);

// Plans a motion again that is too fast for the given time. With "clamp": in the shortest time.
// With "warn": as fast as the joints allow, then played faster to keep the given time, with advice
// (W0707). Otherwise nothing changes.
//
// time  the time used for planning; it is updated.
// plan  has `motion` and the `times` at its points; plan_again() makes another one with the updated
//       time, or without a time.
template <class Plan, class PlanAgain>
void keep_time(Vm& vm, const MoveCall& call, std::optional<double>& time, Plan& plan,
               const PlanAgain& plan_again) {
  if (plan.ok() || !plan.motion.too_fast || !time || !(*time > 0.0)) return;
  const TooFast fast = *plan.motion.too_fast;
  const double given = *time;
  const std::optional<double> longer = lengthened(vm, call, fast);
  if (!longer && !may_be_too_fast(vm, call)) return;
  time = longer;
  plan = plan_again();
  if (longer || !plan.ok()) return;
  const double share = given / plan.motion.trajectory->duration();
  plan.motion.trajectory = plan.motion.trajectory->stretched(share);
  for (double& each : plan.times) each *= share;
  advise_too_fast(vm, call, fast);
}

}  // namespace armlet::bind
