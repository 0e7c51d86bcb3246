#include "cell/contact_picking.hpp"

#include "armlet/cell/gripper.hpp"

namespace armlet {
namespace {

std::optional<CellEvent> pick(Cell& cell, int robot) {
  const std::string* nearest = nullptr;
  double least = cell.robot(robot).model->tool().grasp_distance;
  for (const std::string& name : cell.task_objects()) {
    const double distance = grasp_distance(cell, robot, cell.world().at(name));
    if (distance > least || (nearest != nullptr && distance == least)) continue;
    nearest = &name;
    least = distance;
  }
  if (nearest == nullptr || !grasp(cell, robot, *nearest).ok()) return std::nullopt;
  return CellEvent{.t_ns = cell.now_ns(),
                   .kind = CellEventKind::kPicked,
                   .robot = robot,
                   .motion = cell.robot(robot).motion_id,
                   .object = *nearest};
}

std::optional<CellEvent> put_down(Cell& cell, int robot) {
  const CellRobot& arm = cell.robot(robot);
  const Object& object = cell.world().at(arm.held);
  // An object that moved by less than the tolerance of resting has not moved.
  const double moved = (object.T_world_obj.translation() - arm.p_picked).norm();
  if (moved <= kRestTolerance || cell.world().resting_on(object.name).empty()) return std::nullopt;
  const auto released = release(cell, robot);
  return CellEvent{.t_ns = cell.now_ns(),
                   .kind = CellEventKind::kPutDown,
                   .robot = robot,
                   .motion = arm.motion_id,
                   .object = released->object,
                   .support = released->drop.support};
}

}  // namespace

std::optional<CellEvent> pick_or_put_down(Cell& cell, int robot) {
  return cell.robot(robot).held.empty() ? pick(cell, robot) : put_down(cell, robot);
}

}  // namespace armlet
