#include "cell/arm_bodies.hpp"

#include <algorithm>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

void close_fingers(const CellRobot& arm, const World& world, std::vector<ArmSolid>& solids) {
  const Tool& hand = arm.model->tool();
  if (arm.held.empty() || hand.kind != ToolKind::kParallelGripper) return;
  const Object* held = world.find(arm.held);
  if (held == nullptr) return;
  const Eigen::Vector3d across_world = forward(*arm.model, arm.q).linear().col(0);
  const double closed = 0.5 * std::max(hand.stroke - grasp_width(*held, across_world), 0.0);
  const Eigen::Vector3d across = arm.model->T_flange_tool().linear().col(0);
  for (ArmSolid& each : solids) {
    if (!is_finger(each.role)) continue;
    const bool left = each.role == LinkShapeRole::kFingerLeft;
    each.solid.T.translation() += (left ? closed : -closed) * across;
  }
}

}  // namespace armlet
