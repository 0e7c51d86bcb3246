#include "seen_things.hpp"

#include <cmath>

#include "armlet/cell/clearance.hpp"
#include "armlet/cell/fingers.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostFrames = 200;
constexpr std::size_t kMostTouching = 8;  // of a robot
constexpr std::size_t kMostPresses = 64;
constexpr double kReach = 0.25;  // m: pairs farther apart are not shown

// The object that carries the frame, directly or by other frames; empty: none.
std::string carrier_of(const World& world, const NamedFrame* frame) {
  while (frame != nullptr && frame->base == FrameBase::kFrame) frame = world.find_frame(frame->on);
  return frame != nullptr && frame->base == FrameBase::kObject ? frame->on : std::string();
}

std::vector<SeenFrame> frames_of(const World& world) {
  std::vector<SeenFrame> all;
  for (const std::string& name : world.frame_names()) {
    if (all.size() >= kMostFrames) break;
    const auto T_world_frame = world.T_world_frame(name);
    if (!T_world_frame) continue;
    SeenFrame seen{
        .name = name, .object = carrier_of(world, world.find_frame(name)), .T = *T_world_frame};
    if (const Object* object = world.find(seen.object); object != nullptr) {
      seen.T = object->T_world_obj.inverse() * seen.T;
    } else {
      seen.object.clear();
    }
    all.push_back(std::move(seen));
  }
  return all;
}

// A gripper is drawn at the last link, and so is the flange.
int link_of(const Cell& cell, const CellBody& body) {
  const bool is_behind = is_hand(body.role) || body.role == LinkShapeRole::kFlange;
  return body.robot >= 0 && is_behind ? cell.robot(body.robot).model->rows() + 1 : body.frame;
}

}  // namespace

SeenThings things_of(const Cell& cell) {
  SeenThings seen{.frames = frames_of(cell.world())};
  for (int i = 0; i < cell.robot_count(); ++i) {
    if (cell.robot(i).on >= 0) continue;
    for (const Clearance& each : clearances(cell, i, kReach, kMostTouching)) {
      if (!std::isfinite(each.distance) || !each.p_body.allFinite() || !each.p_other.allFinite())
        continue;
      seen.clearances.push_back({.robot = each.body.robot,
                                 .object = each.body.object,
                                 .link = link_of(cell, each.body),
                                 .body = body_text(cell, each.body),
                                 .other_robot = each.other.robot,
                                 .other_object = each.other.object,
                                 .other_link = link_of(cell, each.other),
                                 .other = body_text(cell, each.other),
                                 .distance = each.distance,
                                 .is_at_least = each.at_least,
                                 .is_felt = feels(cell, each.body) && !each.other.object.empty(),
                                 .p_body = each.p_body,
                                 .p_other = each.p_other});
    }
  }
  for (int i = 0; i < cell.robot_count(); ++i) {
    for (const Press& each : cell.presses(i)) {
      if (seen.presses.size() >= kMostPresses || !each.p.allFinite() || !each.force.allFinite())
        continue;
      seen.presses.push_back({.robot = i, .object = each.object, .p = each.p, .force = each.force});
    }
    if (cell.robot(i).model->spec().role != RobotRole::kHand) continue;
    for (const FingerContact& each : finger_contacts(cell, i)) {
      if (seen.presses.size() >= kMostPresses || !(each.force > 0.0)) continue;
      seen.presses.push_back(
          {.robot = i, .object = each.object, .p = each.p, .force = -each.force * each.inward});
    }
  }
  return seen;
}

}  // namespace armlet::lab
