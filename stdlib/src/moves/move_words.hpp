#pragma once
// The report of a move in messages: advice about what it exceeds, or the reason why it is refused.

#include "moves/moves.hpp"

namespace armlet::bind {

// A call and what the blocks around it say: policies, speed, acceleration, tool point, and the time
// that is left. The target is to be added.
[[nodiscard]] MoveCommand command_of(Vm& vm, const MoveCall& call);

// Advice about the limits that the planned motion exceeds.
//
// timed  the call whose time the messages mark; the call itself, unless a path has the time.
void advise_planned(Vm& vm, const MoveCall& call, const MoveCall& timed, const MoveReport& report);

// Advice about the torques, collisions and joint values of a planned motion, as far as it was
// checked.
void advise_checked(Vm& vm, const MoveCall& call, const MoveReport& report);

// The refusal of a report. The model of the call has to be that of the report.
Failed fail_move(Vm& vm, const MoveCall& call, const MoveReport& report);

}  // namespace armlet::bind
