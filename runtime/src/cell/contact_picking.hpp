// Picking up and putting down by contact, for programs without statements for it.
#pragma once

#include <optional>

#include "armlet/cell/cell.hpp"

namespace armlet {

// Distance from the tool point to the nearest grasp point of an object, m.
double grasp_distance(const Cell& cell, int robot, const Object& object);

// To be called when a move of this robot ends. An empty gripper closes on the nearest object of the
// task within its grasp distance; a gripper that holds one opens if the object rests on a surface
// and not where it was picked up.
std::optional<CellEvent> pick_or_put_down(Cell& cell, int robot);

}  // namespace armlet
