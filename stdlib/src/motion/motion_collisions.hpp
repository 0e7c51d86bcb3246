#pragma once
// What motions run into.

#include "armlet/cell/collisions.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Says, as `with (collisions:)` wants it, what the robot of the call would meet on this motion: as
// advice, one for each pair and place of the program, or as R0614; inside with (avoid: true) always
// as the latter.
Answer<void> check_collisions(Vm& vm, const MoveCall& call, const Trajectory& motion);

// R0614 for what a motion that takes so many seconds would meet.
Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration);

}  // namespace armlet::bind
