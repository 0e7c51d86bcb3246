#pragma once
// What fingers hold and press on, as messages.

#include "armlet/cell/fingers.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// W0726: what fingers held has slipped out of them.
void advise_slip(Vm& vm, const CellEvent& event);

// R0637: what has moved presses harder than it can stand, a finger or the tool of an arm.
Answer<void> check_presses(Vm& vm, const MoveCall& call);

}  // namespace armlet::bind
