// What is nearest to the robots of a cell as they are now.
#pragma once

#include <cstddef>
#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// Of the robot with all that it carries, compared with what find_collisions compares it with: each
// pair of two things once. Those nearer than 0.01 mm, which touch or overlap, the deepest first, at
// most `most`; if there are none, the nearest pair that is not of its own links, if it is nearer
// than `reach`.
std::vector<Clearance> clearances(const Cell& cell, int robot, double reach, std::size_t most);

}  // namespace armlet
