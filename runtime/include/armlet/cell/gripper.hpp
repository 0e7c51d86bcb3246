#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "armlet/cell/cell.hpp"

namespace armlet {

// kNothing         the object, or every object, is too far from the tool point.
// kTooWide         the gripper does not open that far.
// kFixed           it belongs to the cell, such as a table.
// kNoHand          the robot has no hand that can grasp.
// kHolding         the hand is closed on something already.
// kUnknownObject   there is no object of that name.
enum class GraspStatus { kGrasped, kNothing, kTooWide, kFixed, kNoHand, kHolding, kUnknownObject };

// object    what was grasped or is meant; with kNothing the nearest one, empty if there is none;
//           with kHolding what is held.
// distance  from the tool point to where a hand may take it (armlet/world/object.hpp), m.
// allowed   how near the tool point must be, m.
// width     of the object along the line on which the fingers close, and stroke of the gripper, m;
//           for kTooWide.
// turned    its width if the gripper were rotated by 90 deg about its approach, m.
struct GraspResult {
  GraspStatus status = GraspStatus::kNothing;
  std::string object{};
  double distance = 0.0;
  double allowed = 0.0;
  double width = 0.0;
  double turned = 0.0;
  double stroke = 0.0;

  [[nodiscard]] bool ok() const { return status == GraspStatus::kGrasped; }
};

// Closes the hand on the object of that name.
GraspResult grasp(Cell& cell, int robot, std::string_view name);

// Closes the hand on the nearest object that is not fixed; of several equally near the first.
GraspResult grasp(Cell& cell, int robot);

// Opens the hand.
//
// object  what it let go.
// drop    how far it fell and onto what; nothing fell if another hand holds it still.
struct Released {
  std::string object;
  Drop drop;
};

// Nothing if the hand was empty.
std::optional<Released> release(Cell& cell, int robot);

// Name of what the hand holds; empty if nothing.
std::string_view holding(const Cell& cell, int robot);

}  // namespace armlet
