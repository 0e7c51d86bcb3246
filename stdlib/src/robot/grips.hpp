#pragma once
// What fingers hold and press on, as messages.

#include "armlet/cell/fingers.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// W0726: what fingers held has slipped out of them.
void advise_slip(Vm& vm, const CellEvent& event);

// R0637: the motion was stopped because a hand or a finger was pressed harder than it can stand.
Answer<void> check_overload(Vm& vm, const MoveCall& call, const MotionReport& report);
// The same, or where the motion has ended it is.
Answer<void> check_presses(Vm& vm, const MoveCall& call, const MotionReport& report);

}  // namespace armlet::bind
