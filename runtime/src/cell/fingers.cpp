#include "armlet/cell/fingers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "cell/descriptions.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

double largest_radius(const Object& object) {
  return solid_of(object.shape).reach() + center_of_mass(object).norm();
}

Vector3d p_world_com(const Object& object) { return object.T_world_obj * center_of_mass(object); }

std::vector<GraspContact> contacts_on(std::span<const FingerContact> contacts,
                                      std::string_view object) {
  std::vector<GraspContact> chosen;
  for (const FingerContact& each : contacts) {
    if (each.object == object)
      chosen.push_back({.p = each.p, .inward = each.inward, .friction = each.friction});
  }
  return chosen;
}

}  // namespace

GraspQuality hand_quality(const Cell& cell, int hand, std::string_view name) {
  const Object& object = cell.world().at(name);
  return grasp_quality(contacts_on(finger_contacts(cell, hand), name), p_world_com(object),
                       largest_radius(object));
}

double carried_part(const Cell& cell, int arm, std::span<const FingerContact> contacts,
                    std::string_view name) {
  constexpr double kLightest = 1e-3;  // kg
  const Object& object = cell.world().at(name);
  std::vector<double> presses;
  for (const FingerContact& each : contacts) {
    if (each.object == name) presses.push_back(each.force);
  }
  Vector6d load = Vector6d::Zero();
  double mass = object.mass;
  for (const std::string& above : cell.world().stacked_on(name))
    mass += cell.world().at(above).mass;
  load.head<3>() = std::max(mass, kLightest) * cell.robot(arm).model->gravity();
  return load_factor(contacts_on(contacts, name), presses, p_world_com(object),
                     largest_radius(object), load);
}

double carried_in_motion(const Cell& cell, int arm) {
  constexpr double kLightest = 1e-3;  // kg
  const std::string& name = cell.robot(arm).held;
  if (name.empty()) return 1.0;
  const std::vector<FingerContact> contacts = finger_contacts(cell, cell.hand_on(arm));
  const Object& object = cell.world().at(name);
  if (object.mass < kLightest) return std::min(carried_part(cell, arm, contacts, name), 1.0);
  std::vector<double> presses;
  for (const FingerContact& each : contacts) {
    if (each.object == name) presses.push_back(each.force);
  }
  Vector6d load = cell.held_wrench(arm);
  const Vector3d off = cell.T_world_tool(arm).translation() - p_world_com(object);
  load.tail<3>() += off.cross(Vector3d(load.head<3>()));
  const auto factor_of = [&](double share) {
    return load_factor(contacts_on(contacts, name), presses, p_world_com(object),
                       largest_radius(object), share * load);
  };
  // load_factor ends at 1000, so this value shows whether the contacts carry any load.
  if (factor_of(1e-3) >= 1000.0) return 1.0;
  return std::min(factor_of(1.0), std::nextafter(1.0, 0.0));
}

HardestFinger hardest_finger(const Cell& cell, int hand) {
  HardestFinger hardest;
  std::vector<double> sums(cell.robot(hand).fingers.size(), 0.0);
  std::vector<std::pair<double, std::string>> most(sums.size());
  for (FingerContact& each : finger_contacts(cell, hand)) {
    if (each.finger < 0) continue;
    const auto i = static_cast<std::size_t>(each.finger);
    sums[i] += each.force;
    if (each.force > most[i].first) most[i] = {each.force, std::move(each.object)};
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (sums[i] > hardest.force)
      hardest = {.finger = static_cast<int>(i), .force = sums[i], .object = most[i].second};
  }
  return hardest;
}

int Cell::add_hand(int index, FingeredHand hand) {
  CellRobot& arm = state(index);
  const auto refuse = [&](std::string_view why) {
    throw ArgumentError(fmt::format("A hand cannot be mounted on \"{}\": {}.", arm.name, why));
  };
  if (arm.on >= 0) refuse("it is a hand itself");
  if (arm.motion) refuse("it is moving");
  if (!arm.held.empty()) refuse(fmt::format("it holds \"{}\"", arm.held));
  if (hand_on(index) >= 0) refuse("it has one");
  const auto check_name = [&](const Robot& part) {
    if (find_robot(part.name()))
      refuse(fmt::format("there is already a robot \"{}\"", part.name()));
  };
  check_name(hand.palm);
  for (const Robot& finger : hand.fingers) check_name(finger);
  set_model(index, std::make_shared<const Robot>(arm.model->with_tool(hand.tool)));
  const auto add = [&](Robot& model, int palm) {
    return join(std::make_shared<const Robot>(std::move(model)), {}, index, palm);
  };
  const int palm = add(hand.palm, -1);
  for (Robot& finger : hand.fingers) {
    const int added = add(finger, palm);
    state(palm).fingers.push_back(added);
  }
  state(palm).force = hand.force;
  return palm;
}

int Cell::hand_on(int arm) const {
  for (int i = 0; i < robot_count(); ++i) {
    const CellRobot& each = robots_[static_cast<std::size_t>(i)];
    if (each.on == arm && each.hand < 0) return i;
  }
  return -1;
}

void Cell::follow_hands() {
  for (CellRobot& palm : robots_) {
    for (int i = 0; i < static_cast<int>(palm.fingers.size()); ++i) {
      CellRobot& finger =
          robots_[static_cast<std::size_t>(palm.fingers[static_cast<std::size_t>(i)])];
      if (finger.motion) {
        const int bend = bend_joint(i);
        palm.q[i + 1] = finger.q[bend];
        palm.qd[i + 1] = finger.qd[bend];
        palm.qdd[i + 1] = finger.qdd[bend];
      } else {
        finger.q = finger_joints(i, palm.q);
        finger.qd = finger_joints(i, palm.qd);
        finger.qdd = finger_joints(i, palm.qdd);
      }
    }
  }
  for (int i = 0; i < robot_count(); ++i) {
    if (robots_[static_cast<std::size_t>(i)].on >= 0 && world_.has_mounted(i)) carry_along(i);
  }
}

void Cell::review_grip(int index) {
  const int hand = hand_on(index);
  const std::vector<FingerContact> contacts = finger_contacts(*this, hand);
  if (const std::string held = robot(index).held; !held.empty()) {
    const double part = carried_part(*this, index, contacts, held);
    if (part >= 1.0) return;
    slip(index, part, false);
    return;
  }
  std::string best;
  double most = 1.0;
  for (const FingerContact& each : contacts) {
    if (each.object == best || world_.at(each.object).fixed || holder_of(each.object)) continue;
    const double part = carried_part(*this, index, contacts, each.object);
    if (part < most || (part == most && !best.empty())) continue;
    best = each.object;
    most = part;
  }
  if (!best.empty()) take(index, best);
}

void Cell::loosen_grip(int index, const Trajectory& motion) {
  const CellRobot& part = robot(index);
  const std::string held = robot(part.on).held;
  if (held.empty()) return;
  const int hand = part.hand < 0 ? index : part.hand;
  Eigen::VectorXd q = robot(hand).q;
  if (part.hand < 0) {
    q = motion.end();
  } else {
    const auto& fingers = robot(hand).fingers;
    const auto i = static_cast<int>(std::ranges::find(fingers, index) - fingers.begin());
    q[i + 1] = motion.end()[bend_joint(i)];
  }
  if (carried_part(*this, part.on, finger_contacts(*this, hand, q), held) < 1.0) let_go(part.on);
}

}  // namespace armlet
