#pragma once

#include <span>
#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// The collisions of a finger, or of all fingers of a hand with fingers, on this motion while the
// arm is at rest. They are compared with fixed objects, what other robots carry, and robots in
// their present poses, except the links next to the fingers; with the palm and what is fixed to it;
// and with the other fingers along their present motions or those of `beside`. Objects that can be
// grasped are left out. In order of time.
std::vector<CellCollision> find_finger_collisions(const Cell& cell, int robot,
                                                  const Trajectory& motion,
                                                  std::span<const MotionBeside> beside);

}  // namespace armlet
