#pragma once
// The bodies of an arm with its gripper in the present state.

#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/collision/arm_solids.hpp"

namespace armlet {

[[nodiscard]] inline bool is_finger(LinkShapeRole role) {
  return role == LinkShapeRole::kFingerLeft || role == LinkShapeRole::kFingerRight;
}

// Moves the fingers of a gripper to the width of the object that it holds.
void close_fingers(const CellRobot& arm, const World& world, std::vector<ArmSolid>& solids);

}  // namespace armlet
