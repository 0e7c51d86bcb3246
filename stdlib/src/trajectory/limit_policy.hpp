#pragma once
// What a block `with (limits: ...)` makes of moves that would leave the limits of the joints.

#include <optional>

#include "motion/move_failures.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Joint values as a move takes them: inside the limits where the blocks around the call say
// "clamp", with advice (W0757) that says which joint was asked for how much more; else as given.
//
// call  learns of the joint that was farthest outside.
Eigen::VectorXd clamped(Vm& vm, MoveCall& call, const Eigen::VectorXd& q);

// Where the blocks around the call say "warn": gives it the robot with limits on joint values that
// include `q`, if that has values, and leave every other motion room. False elsewhere: the limits
// hold.
bool lift_limits(Vm& vm, MoveCall& call, const Eigen::VectorXd& q = {});

// The joint that a motion takes farthest beyond the limits of the robot as it is in the cell; with
// advice (W0758) if there is one. What was clamped where the motion stays inside.
LimitExcess report_excess(Vm& vm, const MoveCall& call, const Trajectory& motion);

// Whether a motion that is too fast is made all the same, with advice.
[[nodiscard]] bool may_be_too_fast(Vm& vm, const MoveCall& call);
// The time that a motion takes instead of a shorter one where the blocks say "clamp", with advice
// (W0759); nothing elsewhere.
std::optional<double> lengthened(Vm& vm, const MoveCall& call, const TooFast& fast);

// Plans again what is too fast for the time that was given: with "clamp" in the least time, with
// "warn" as fast as the joints allow and then run faster, in the given time, with advice (W0707).
// Elsewhere everything stays as it is.
//
// time  as it was planned with; it changes.
// plan  with `motion` and the `times` at its points; plan_again() makes another with the time as it
//       is then, or with none.
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
