#pragma once

#include <span>
#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// What a finger, or all fingers of a hand, would meet on this motion while the arm stands: fixed
// objects, what other robots carry, and robots where they are now, but for the links next to the
// hand; the palm and what is fixed on it, and the other fingers, as they move now or, of `beside`,
// from now on. Objects that could be taken do not count. In order of time.
std::vector<CellCollision> find_finger_collisions(const Cell& cell, int robot,
                                                  const Trajectory& motion,
                                                  std::span<const MotionBeside> beside);

}  // namespace armlet
