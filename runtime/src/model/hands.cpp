#include "armlet/model/hands.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Dimensions of a finger, m: distance and height of its first joint, and its two links.
constexpr double kPalmHeight = 0.0415, kSpreadOffset = 0.025;
constexpr double kOut = 0.05, kUp = 0.0339, kMedial = 0.06994, kDistal = 0.05;

// Adds the links that bend; `base` is -1 or the spread link, whose y axis points outwards.
void add_finger(MechanismSpec& spec, int finger, int base, const Isometry3d& T_base_finger) {
  const std::string name = fmt::format("finger{}", finger);
  const int medial = static_cast<int>(spec.bodies.size());
  spec.bodies.push_back({.name = name + "_medial",
                         .joint_name = name + "_bend",
                         .parent = base,
                         .joint = BodyJoint::kRevolute,
                         .T_parent_joint = T_base_finger * make_translation({0, kOut, kUp}),
                         .axis = Vector3d::UnitX()});
  spec.bodies.push_back({.name = name + "_distal",
                         .joint_name = name + "_curl",
                         .parent = medial,
                         .joint = BodyJoint::kRevolute,
                         .T_parent_joint = make_pose(rot_x(kPi / 4), {0, kMedial, 0}),
                         .axis = Vector3d::UnitX()});
  spec.tips.push_back(
      {fmt::format("tip{}", finger), medial + 1, make_translation({0, kDistal, 0})});
}

void add_spread(MechanismSpec& spec, int finger, double side) {
  spec.bodies.push_back({.name = fmt::format("finger{}_base", finger),
                         .joint_name = fmt::format("finger{}_spread", finger),
                         .joint = BodyJoint::kRevolute,
                         .T_parent_joint = make_translation({side * kSpreadOffset, 0, kPalmHeight}),
                         .axis = -side * Vector3d::UnitZ()});
}

Hand hand_of(Mechanism mechanism, const Tool& tool) {
  Hand hand{mechanism.name(), mechanism.source(), tool, std::nullopt};
  hand.mechanism.emplace(std::move(mechanism));
  return hand;
}

}  // namespace

Mechanism make_barrett_hand() {
  MechanismSpec spec;
  spec.name = "barrett_hand";
  spec.source = "Barrett Technology BH8-280; dimensions of the TU Berlin model";
  spec.base_name = "palm";
  add_spread(spec, 1, -1.0);
  add_finger(spec, 1, 0, Isometry3d::Identity());
  const int second = static_cast<int>(spec.bodies.size());
  add_spread(spec, 2, 1.0);
  add_finger(spec, 2, second, Isometry3d::Identity());
  add_finger(spec, 3, -1, make_pose(rot_z(kPi), {0, 0, kPalmHeight}));
  spec.actuators = {{.name = "spread", .lower = 0.0, .upper = kPi}};
  for (int finger = 1; finger <= 3; ++finger) {
    spec.actuators.push_back(
        {.name = fmt::format("f{}", finger), .lower = 0.0, .upper = deg_to_rad(140.0)});
  }
  spec.coupling = Eigen::MatrixXd::Zero(8, 4);
  spec.coupling(0, 0) = spec.coupling(3, 0) = 1.0;
  const int bends[] = {1, 4, 6};
  for (int finger = 0; finger < 3; ++finger) {
    spec.coupling(bends[finger], finger + 1) = 1.0;
    spec.coupling(bends[finger] + 1, finger + 1) = 1.0 / 3.0;
  }
  spec.offset = Eigen::VectorXd::Zero(8);
  return Mechanism(std::move(spec));
}

namespace {

constexpr double kBendSpeed = kPi * 140.0 / 180.0, kSpreadSpeed = 2.0 * kPi;  // rad/s
constexpr double kGraspPoint =
    0.165;  // m, from the flange to between the fingertips that close on a ball

// Small motors behind worm gears: at full speed, or at rest, within 3 ms.
Joint driven(const DhRow& dh, double upper, double speed) {
  return {.dh = dh,
          .lower = 0.0,
          .upper = upper,
          .max_speed = speed,
          .max_accel = 1000.0 * speed,
          .max_jerk = 1e6 * speed};
}

}  // namespace

FingeredHand make_barrett_robots(const std::string& name) {
  const double bent = deg_to_rad(140.0);
  const char* source = "Barrett Technology BH8-280; dimensions of the TU Berlin model";
  RobotSpec palm{.name = name, .source = source, .role = RobotRole::kHand};
  palm.joints = {driven({}, kPi, kSpreadSpeed)};
  for (int i = 0; i < 3; ++i) palm.joints.push_back(driven({}, bent, kBendSpeed));
  palm.T_flange_tool = make_translation({0.0, 0.0, kGraspPoint});
  std::vector<Robot> fingers;
  for (int i = 0; i < 3; ++i) {
    RobotSpec finger{
        .name = fmt::format("{}.f{}", name, i + 1), .source = source, .role = RobotRole::kFinger};
    // The spread rotates about z of its base, upwards for the first finger and downwards for the
    // second, from the position where x points outwards.
    const double side = i == 0 ? 1.0 : -1.0;
    if (i < 2) {
      finger.T_world_base =
          make_pose(i == 0 ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : rot_x(kPi),
                    {-side * kSpreadOffset, 0.0, kPalmHeight});
      finger.joints = {
          driven({.theta = side * 0.5 * kPi, .d = side * kUp, .a = kOut, .alpha = side * 0.5 * kPi},
                 kPi, kSpreadSpeed)};
    } else {
      // The outward direction is -y of the palm; the finger bends about -x.
      Eigen::Matrix3d R_palm_finger;
      R_palm_finger << 0, 0, -1, -1, 0, 0, 0, 1, 0;
      finger.T_world_base = make_pose(R_palm_finger, {0.0, -kOut, kPalmHeight + kUp});
    }
    finger.joints.push_back(driven({.a = kMedial}, bent, kBendSpeed));
    finger.joints.push_back(
        driven({.theta = 0.25 * kPi, .a = kDistal}, bent / 3.0, kBendSpeed / 3.0));
    fingers.emplace_back(std::move(finger));
  }
  return {.palm = Robot(std::move(palm)),
          .fingers = std::move(fingers),
          .tool = {.kind = ToolKind::kFingers, .length = kGraspPoint}};
}

Eigen::VectorXd finger_joints(int finger, const Eigen::VectorXd& q_palm) {
  check_size("q_palm", q_palm.size(), 4);
  const double bend = q_palm[finger + 1];
  if (finger < 2) return Eigen::Vector3d(q_palm[0], bend, bend / 3.0);
  return Eigen::Vector2d(bend, bend / 3.0);
}

Mechanism make_parallel_gripper() {
  MechanismSpec spec;
  spec.name = "parallel_gripper";
  spec.source = "Franka Hand, Franka Emika";
  spec.base_name = "hand";
  const double sides[] = {1.0, -1.0};
  for (const double side : sides) {
    const std::string name = side > 0.0 ? "left" : "right";
    spec.bodies.push_back({.name = name + "_finger",
                           .joint_name = name + "_slide",
                           .joint = BodyJoint::kPrismatic,
                           .T_parent_joint = make_translation({0, 0, 0.0584}),
                           .axis = side * Vector3d::UnitY()});
  }
  spec.actuators = {
      {.name = "opening", .lower = 0.0, .upper = 0.08, .max_speed = 0.1, .max_effort = 70.0}};
  spec.coupling = Eigen::MatrixXd::Constant(2, 1, 0.5);
  spec.offset = Eigen::VectorXd::Zero(2);
  spec.tips.push_back({"grasp", -1, make_translation({0, 0, 0.1034})});
  return Mechanism(std::move(spec));
}

const std::vector<std::string_view>& hand_names() {
  static const std::vector<std::string_view> names = {"barrett_hand", "parallel_gripper",
                                                      "suction_cup"};
  return names;
}

std::optional<Hand> make_hand(std::string_view name) {
  // The distance from the palm to the centre of a ball that the closed fingers hold.
  if (name == "barrett_hand") return hand_of(make_barrett_hand(), point_tool(0.1));
  if (name == "parallel_gripper") {
    return hand_of(make_parallel_gripper(), parallel_gripper(0.080, 0.1034, 70.0));
  }
  if (name == "suction_cup") {
    return Hand{"suction_cup", "generic bellows cup of 30 mm", suction_cup(0.015), std::nullopt};
  }
  return std::nullopt;
}

}  // namespace armlet
