#include "armlet/cell/gripper.hpp"

#include "cell/contact_picking.hpp"

namespace armlet {
namespace {

// Why this gripper cannot close on this object, distance included; kGrasped if it can.
GraspResult judge(const Cell& cell, int robot, const Object& object) {
  const Tool& hand = cell.robot(robot).model->tool();
  const Eigen::Isometry3d T_world_tool = cell.T_world_tool(robot);
  GraspResult result{.object = object.name,
                     .distance = grasp_distance(cell, robot, object),
                     .allowed = hand.grasp_distance,
                     .width = grasp_width(object, T_world_tool.linear().col(0)),
                     .turned = grasp_width(object, T_world_tool.linear().col(1)),
                     .stroke = hand.stroke};
  if (object.fixed) {
    result.status = GraspStatus::kFixed;
  } else if (result.distance > result.allowed) {
    result.status = GraspStatus::kNothing;
  } else if (hand.kind == ToolKind::kParallelGripper && result.width > result.stroke) {
    result.status = GraspStatus::kTooWide;
  } else {
    result.status = GraspStatus::kGrasped;
  }
  return result;
}

// The reason why a gripper cannot close on anything at all.
std::optional<GraspResult> hand_is_useless(const Cell& cell, int robot) {
  const CellRobot& arm = cell.robot(robot);
  if (!arm.model->tool().can_grasp()) return GraspResult{.status = GraspStatus::kNoHand};
  if (arm.held.empty()) return std::nullopt;
  return GraspResult{.status = GraspStatus::kHolding, .object = arm.held};
}

}  // namespace

double grasp_distance(const Cell& cell, int robot, const Object& object) {
  return grasp_distance(object, cell.T_world_tool(robot).translation());
}

GraspResult grasp(Cell& cell, int robot, std::string_view name) {
  if (auto useless = hand_is_useless(cell, robot)) return *useless;
  const Object* object = cell.world().find(name);
  if (object == nullptr) {
    return {.status = GraspStatus::kUnknownObject, .object = std::string(name)};
  }
  GraspResult result = judge(cell, robot, *object);
  if (result.ok()) cell.take(robot, name);
  return result;
}

GraspResult grasp(Cell& cell, int robot) {
  if (auto useless = hand_is_useless(cell, robot)) return *useless;
  GraspResult nearest{.allowed = cell.robot(robot).model->tool().grasp_distance};
  for (std::size_t i = 0; i < cell.world().size(); ++i) {
    const Object& object = cell.world().object(i);
    if (object.fixed) continue;
    GraspResult candidate = judge(cell, robot, object);
    if (nearest.object.empty() || candidate.distance < nearest.distance) nearest = candidate;
  }
  if (nearest.ok()) cell.take(robot, nearest.object);
  return nearest;
}

std::optional<Released> release(Cell& cell, int robot) {
  std::string object = cell.robot(robot).held;
  if (object.empty()) return std::nullopt;
  const Drop drop = cell.let_go(robot);
  return Released{.object = std::move(object), .drop = drop};
}

std::string_view holding(const Cell& cell, int robot) { return cell.robot(robot).held; }

}  // namespace armlet
