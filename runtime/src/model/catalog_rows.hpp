#pragma once

#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/model/robot.hpp"

// The rows of the catalogue of arms.
namespace armlet::catalog {

inline constexpr double kDeg = std::numbers::pi / 180.0;
inline constexpr JointKind R = JointKind::kRevolute;
inline constexpr JointKind P = JointKind::kPrismatic;

struct Rates {
  double accel = 0.0, jerk = 0.0;
};

// A joint and its link. The inertia is about the centre of mass: xx, yy, zz, xy, xz, yz. A speed,
// effort, acceleration or jerk of 0 is not given by the source.
struct Row {
  JointKind kind = R;
  DhRow dh{};
  double lower = 0.0, upper = 0.0, max_speed = 0.0;
  double mass = 0.0;
  std::array<double, 3> com{};
  std::array<double, 6> inertia{};
  double motor_inertia = 0.0, gear = 1.0;
  Friction friction{};
  double max_effort = 0.0;
  Rates rates{};
};

// An arm: a row of the catalogue. The members that lists show come first.
struct Arm {
  std::string_view name;
  std::string_view second_name{};  // empty: none
  std::string_view source;
  std::string_view help;  // of robots.NAME
  std::span<const Row> joints;
  DhConvention convention = DhConvention::kStandard;
  InertiaCheck inertia_check = InertiaCheck::kRigidBody;
  std::vector<double> home;  // deg for revolute joints, m for prismatic ones
  double stroke = 0.0;       // of the gripper, m; 0: no gripper
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_flange_tool = Eigen::Isometry3d::Identity();
};

// The catalogue, in this order.
std::span<const Arm> teaching_arms();
std::span<const Arm> workshop_arms();
std::span<const Arm> light_arms();

}  // namespace armlet::catalog
