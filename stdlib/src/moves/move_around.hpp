#pragma once
// Moves around obstacles.

#include <vector>

#include "armlet/cell/way_around.hpp"
#include "moves/moves.hpp"

namespace armlet::bind {

// The goal of a path search.
//
// any_branch  the goal is a position in space, so that other solutions of its inverse kinematics
//             may be used.
struct WayWanted {
  Eigen::VectorXd goal{};
  bool any_branch = false;
  MoveSettings move{};
  WayOptions search{};
};

// A motion around obstacles from the present joint values of the robot of the call; or the failure
// with the reason why none was found. The call must have its model (choose_model).
Answer<WayAround> way_around(Vm& vm, const MoveCall& call, const WayWanted& wanted);

// Starts this motion, as `with (avoid: true)` requests: if it collides, a motion around the
// obstacle is started instead.
Started start_avoiding(Vm& vm, const MoveCall& call, Trajectory straight, const WayWanted& wanted);

}  // namespace armlet::bind
