#include "armlet/model/catalog.hpp"

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

}  // namespace

Robot make_arm(std::span<const Row> rows, const Description& description) {
  RobotSpec spec;
  spec.name = description.name;
  spec.source = description.source;
  spec.convention = description.convention;
  spec.inertia_check = description.inertia_check;
  spec.T_world_base = description.T_world_base;
  spec.T_flange_tool = description.T_flange_tool;
  if (description.stroke > 0.0) spec.tool = parallel_gripper(description.stroke, 0.0);
  spec.home.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
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
    spec.home[static_cast<Eigen::Index>(i)] =
        row.kind == R ? deg_to_rad(description.home[i]) : description.home[i];
  }
  return Robot(std::move(spec));
}

}  // namespace catalog

namespace {

struct Entry {
  std::string_view name;
  Robot (*make)();
};

constexpr Entry kEntries[] = {
    {"planar2", make_planar2},   {"planar3", make_planar3}, {"anthropomorphic", make_rrr3},
    {"scara", make_scara},       {"scorbot", make_scorbot}, {"puma560", make_puma560},
    {"stanford", make_stanford}, {"pa10_6", make_pa10_6},   {"pa10", make_pa10},
    {"irb120", make_irb120},     {"ur3", make_ur3},         {"ur5", make_ur5},
    {"ur10", make_ur10},         {"panda", make_panda},     {"iiwa14", make_iiwa14},
    {"arm7", make_arm7}};

struct Alias {
  std::string_view name, robot;
};
constexpr Alias kAliases[] = {{"rrr3", "anthropomorphic"}, {"planar2r", "planar2"},
                              {"planar3r", "planar3"},     {"scorbot_er4u", "scorbot"},
                              {"pa10_7", "pa10"},          {"iiwa", "iiwa14"},
                              {"abb_irb120", "irb120"}};

}  // namespace

const std::vector<std::string_view>& catalog_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const Entry& entry : kEntries) list.push_back(entry.name);
    return list;
  }();
  return names;
}

std::shared_ptr<const Robot> make_robot(std::string_view name) {
  for (const Alias& alias : kAliases) {
    if (alias.name == name) name = alias.robot;
  }
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return std::make_shared<const Robot>(entry.make());
  }
  return nullptr;
}

}  // namespace armlet
