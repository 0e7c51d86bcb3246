#pragma once
// What a block `with (limits: ...)` makes of moves that would leave the limits of the joints.

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

}  // namespace armlet::bind
