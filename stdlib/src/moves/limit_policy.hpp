#pragma once
// The effect of a block `with (limits: ...)` on motions that would exceed the limits of the joints.

#include <optional>
#include <vector>

#include "moves/move_failures.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The joint values that a move uses. If the blocks around the call say "clamp": clamped to the
// limits, with advice (W0757) that names the joint and the excess; otherwise unchanged.
//
// call  gets the joint that was farthest outside.
Eigen::VectorXd clamped(Vm& vm, MoveCall& call, const Eigen::VectorXd& q);
void advise_clamped(Vm& vm, const MoveCall& call, const std::vector<LimitViolation>& moved);

// If the blocks around the call say "warn": gives the call a robot with wider limits on joint
// values. Otherwise returns false: the limits hold.
bool lift_limits(Vm& vm, MoveCall& call);

// Advice (W0758) about joint values outside the limits of the robot in the cell.
void advise_beyond(Vm& vm, const MoveCall& call, const std::vector<LimitViolation>& beyond);

// Whether a motion that is too fast is executed nevertheless, with advice.
[[nodiscard]] bool may_be_too_fast(Vm& vm, const MoveCall& call);
// The longer time of a motion that is too fast, if the blocks say "clamp", with advice (W0759);
// otherwise nullopt.
std::optional<double> lengthened(Vm& vm, const MoveCall& call, const TooFast& fast);
void advise_lengthened(Vm& vm, const MoveCall& call, const TooFast& fast);

}  // namespace armlet::bind
