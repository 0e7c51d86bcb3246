#pragma once
// The reasons why a move is impossible, as messages with numbers, marks and a fix.

#include <string>

#include "armlet/trajectory/cartesian_line.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The target tilts the tool, which this robot cannot do.
Failed fail_tilted(Vm& vm, const MoveCall& call, const PosC& target);
// The reason that the target tilts the tool, as half a sentence.
std::string tilt_reason(const Robot& robot);
// `start`: joint values at the beginning of the line.
Failed fail_line(Vm& vm, const MoveCall& call, const Eigen::VectorXd& start, const PosC& target,
                 const LineFault& fault);
Failed fail_joint_count(Vm& vm, const MoveCall& call, int count);
// One of several points is outside the limits: "2nd".
Failed fail_outside_at(Vm& vm, const MoveCall& call, const std::string& which,
                       const LimitViolation& outside);
// The points are inside the limits, but the curve between them is not.
Failed fail_swings_outside(Vm& vm, const MoveCall& call, const LimitViolation& outside);
// A trajectory does not start at the present joint values of the robot.
Failed fail_elsewhere(Vm& vm, const MoveCall& call, int joint, double starts, double stands);
Failed fail_planner(Vm& vm, const MoveCall& call, std::string_view planner);
// The planner makes joint speeds jump.
Failed fail_no_ramps(Vm& vm, const MoveCall& call, std::string_view planner);
Failed fail_no_time(Vm& vm, const MoveCall& call, double distance);
// W0707: classic moves are planned although they exceed limits.
void advise_too_fast(Vm& vm, const MoveCall& call, const TooFast& fast);

}  // namespace armlet::bind
