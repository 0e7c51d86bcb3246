#include "armlet/model/catalog.hpp"

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/model/robot.hpp"
#include "catalog_rows.hpp"

namespace armlet {
namespace catalog {
namespace {

Link make_link(const Row& row) {
  const auto& [xx, yy, zz, xy, xz, yz] = row.inertia;
  Link link;
  link.mass = row.mass;
  link.com = Eigen::Vector3d(row.com[0], row.com[1], row.com[2]);
  link.inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  link.motor_inertia = row.motor_inertia;
  link.gear = row.gear;
  link.friction = row.friction;
  return link;
}

Robot make_arm(const Arm& arm) {
  RobotSpec spec;
  spec.name = arm.name;
  spec.source = arm.source;
  spec.convention = arm.convention;
  spec.inertia_check = arm.inertia_check;
  spec.T_world_base = arm.T_world_base;
  spec.T_flange_tool = arm.T_flange_tool;
  if (arm.stroke > 0.0) spec.tool = parallel_gripper(arm.stroke, 0.0);
  check_size("home", static_cast<Eigen::Index>(arm.home.size()),
             static_cast<Eigen::Index>(arm.joints.size()));
  spec.home.resize(static_cast<Eigen::Index>(arm.joints.size()));
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Row& row = arm.joints[i];
    Joint joint{.kind = row.kind,
                .dh = row.dh,
                .lower = row.lower,
                .upper = row.upper,
                .max_speed = row.max_speed,
                .max_accel = row.rates.accel,
                .max_jerk = row.rates.jerk};
    if (row.max_effort > 0.0) joint.max_effort = row.max_effort;
    spec.joints.push_back(joint);
    spec.links.push_back(make_link(row));
    spec.home[static_cast<Eigen::Index>(i)] = row.kind == R ? deg_to_rad(arm.home[i]) : arm.home[i];
  }
  return Robot(std::move(spec));
}

// All rows, one after the other.
std::vector<const Arm*> all_arms() {
  std::vector<const Arm*> all;
  for (const auto& arms : {teaching_arms(), workshop_arms(), light_arms()}) {
    for (const Arm& arm : arms) all.push_back(&arm);
  }
  return all;
}

}  // namespace
}  // namespace catalog

std::span<const CatalogArm> catalog_arms() {
  static const std::vector<CatalogArm> entries = [] {
    std::vector<CatalogArm> list;
    for (const catalog::Arm* arm : catalog::all_arms())
      list.push_back({arm->name, arm->second_name, arm->source, arm->help});
    return list;
  }();
  return entries;
}

const std::vector<std::string_view>& catalog_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const CatalogArm& entry : catalog_arms()) list.push_back(entry.name);
    return list;
  }();
  return names;
}

std::shared_ptr<const Robot> make_robot(std::string_view name) {
  for (const catalog::Arm* arm : catalog::all_arms()) {
    if (!name.empty() && (arm->name == name || arm->second_name == name))
      return std::make_shared<const Robot>(catalog::make_arm(*arm));
  }
  return nullptr;
}

}  // namespace armlet
