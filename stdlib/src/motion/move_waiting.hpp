#pragma once
// A motion from the call that starts it to the Move it gives.

#include "armlet/trajectory/trajectory.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// Starts a planned trajectory. A robot that slows down after a velocity command goes on with its
// speed.
//
// length  of the whole move, m. A move that is stopped on the way tells how far the point that it
//         moves got instead.
Started start_motion(Vm& vm, const MoveCall& call, Trajectory trajectory, double length,
                     MotionNotes notes = {});

// A move that is not made: over at once.
std::unique_ptr<Waiting> no_move();

}  // namespace armlet::bind
