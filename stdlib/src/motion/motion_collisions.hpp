#pragma once
// What motions run into.

#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Says, as `with (collisions:)` wants it, what the robot of the call would meet on this motion: as
// advice, one for each pair and place of the program, or as R0614.
Answer<void> check_collisions(Vm& vm, const MoveCall& call, const Trajectory& motion);

}  // namespace armlet::bind
