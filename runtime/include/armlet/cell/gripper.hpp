#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "armlet/cell/cell.hpp"

namespace armlet {

// kNothing         the object, or every object, is too far from the tool point.
// kTooWide         the gripper does not open that far.
// kFixed           the object is a fixed part of the cell, such as a table.
// kNoHand          the robot has no gripper that can grasp.
// kHolding         the gripper already holds something.
// kUnknownObject   there is no object of that name.
enum class GraspStatus { kGrasped, kNothing, kTooWide, kFixed, kNoHand, kHolding, kUnknownObject };

// object    that was grasped or is meant; with kNothing the nearest one, empty if there is none;
//           with kHolding the held one.
// distance  from the tool point to the nearest grasp point of the object (armlet/world/object.hpp),
//           m.
// allowed   the largest allowed distance, m.
// width     of the object along the direction in which the fingers close, and stroke of the
//           gripper, m; for kTooWide.
// turned    width along that direction after the gripper is rotated by 90 deg about its approach,
//           m.
//           approach, m.
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

// Closes the gripper on the object of that name.
GraspResult grasp(Cell& cell, int robot, std::string_view name);

// Closes the gripper on the nearest object that is not fixed; of several equally near ones, the
// first.
GraspResult grasp(Cell& cell, int robot);

// Opens the gripper.
//
// object  that was released.
// drop    how far it fell and onto what; nothing fell if another robot still holds it.
struct Released {
  std::string object;
  Drop drop;
};

// Nothing if the gripper was empty.
std::optional<Released> release(Cell& cell, int robot);

// Name of the object in the gripper; empty if there is none.
std::string_view holding(const Cell& cell, int robot);

}  // namespace armlet
