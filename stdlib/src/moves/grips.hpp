#pragma once
// Messages about objects that fingers hold and about their contact forces.

#include "armlet/cell/fingers.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// W0726: an object has slipped out of the fingers.
void advise_slip(Vm& vm, const CellEvent& event);

// R0637: the motion was stopped because the contact force on a hand or finger exceeded its limit.
Answer<void> check_overload(Vm& vm, const MoveCall& call, const MotionReport& report);
// Fails with R0637 as above, also for the contact force after the end of the motion.
Answer<void> check_presses(Vm& vm, const MoveCall& call, const MotionReport& report);

}  // namespace armlet::bind
