#pragma once
// A motion from the call that starts it to the Move that the call returns.

#include "armlet/trajectory/trajectory.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// Starts a planned trajectory. A robot that decelerates after a velocity command continues with its
// present speed.
//
// length  of the whole move, m. A move that is stopped before its end reports the path length of
//         the moving point instead.
Started start_motion(Vm& vm, const MoveCall& call, Trajectory trajectory, double length,
                     MotionNotes notes = {});

// A move that is not executed: it has ended at once.
std::unique_ptr<Waiting> no_move();

}  // namespace armlet::bind
