#pragma once
// Moves around what is in the way.

#include <vector>

#include "armlet/cell/way_around.hpp"
#include "motion/moves.hpp"

namespace armlet::bind {

// What is wanted of a way.
//
// any_branch  the goal is a position in space, so that other solutions of its inverse kinematics
//             will do.
struct WayWanted {
  Eigen::VectorXd goal{};
  bool any_branch = false;
  MoveSettings move{};
  WayOptions search{};
};

// A motion around what stands in the way, from where the robot of the call is; or the failure that
// tells why there is none. The call has its model.
Answer<WayAround> way_around(Vm& vm, const MoveCall& call, const WayWanted& wanted);

// Starts this motion, as `with (avoid: true)` wants it: where it runs into something, one around
// that instead.
Started start_avoiding(Vm& vm, const MoveCall& call, Trajectory straight, const WayWanted& wanted);

}  // namespace armlet::bind
