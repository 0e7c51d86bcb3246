// Distances between the robots of a cell and the bodies nearest to them.
#pragma once

#include <cstddef>
#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// Distances between the robot, with all that it carries, and the bodies that find_collisions
// compares it with; each pair of two things once. Returns the pairs nearer than 0.01 mm (which
// touch or overlap), the deepest first, at most `most`. If there are none: the nearest pair, if it
// is nearer than `reach`; pairs of the robot's own links are left out then.
std::vector<Clearance> clearances(const Cell& cell, int robot, double reach, std::size_t most);

}  // namespace armlet
