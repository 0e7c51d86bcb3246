// Picking up and putting down by contact, for programs without verbs for it.
#pragma once

#include <optional>

#include "armlet/cell/cell.hpp"

namespace armlet {

// Distance from the tool point to where a hand may take an object, m.
double grasp_distance(const Cell& cell, int robot, const Object& object);

// To be asked when a move of this robot ends. An empty hand closes on the nearest object of the
// task within its grasp distance; a hand that holds one opens if that rests on a surface at another
// place than where it was picked up.
std::optional<CellEvent> pick_or_put_down(Cell& cell, int robot);

}  // namespace armlet
