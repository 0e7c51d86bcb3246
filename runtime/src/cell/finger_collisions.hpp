#pragma once

#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// What a finger, or all fingers of a hand, would meet on this motion while the arm stands: fixed
// objects, what other robots carry, and robots where they are now, but for the hand itself and the
// links next to it. Objects that could be taken do not count. In order of time, of each finger and
// thing the deepest body.
std::vector<CellCollision> find_finger_collisions(const Cell& cell, int robot,
                                                  const Trajectory& motion);

}  // namespace armlet
