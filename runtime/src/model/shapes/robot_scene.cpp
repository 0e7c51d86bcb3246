#include "armlet/model/robot_scene.hpp"

#include <fmt/format.h>

#include <array>

#include "model/shapes/shape_triangles.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;

enum Look : std::size_t { kLight, kDark, kAccent, kTool, kLooks };

Look look_of(LinkShapeRole role) {
  switch (role) {
    case LinkShapeRole::kBase:
    case LinkShapeRole::kJoint:
    case LinkShapeRole::kFlange:
      return kDark;
    case LinkShapeRole::kLink:
      return kLight;
    case LinkShapeRole::kMark:
      return kAccent;
    case LinkShapeRole::kTool:
    case LinkShapeRole::kFingerLeft:
    case LinkShapeRole::kFingerRight:
      break;
  }
  return kTool;
}

// The colours of the page in its light theme: #e0e4ea, #6a727e, #0072b2, #7b8490.
std::vector<GlbMaterial> looks() {
  return {{.name = "link", .color = {0.7454, 0.7758, 0.8228, 1.0}},
          {.name = "joint", .color = {0.1441, 0.1683, 0.2086, 1.0}},
          {.name = "mark", .color = {0.0, 0.1683, 0.4452, 1.0}},
          {.name = "tool", .color = {0.1981, 0.2307, 0.2789, 1.0}, .metallic = 0.3}};
}

// The joint's rotation or translation by q, in its own frame.
Isometry3d moved_by(const Robot& robot, int i, double q) {
  if (robot.is_revolute(i)) return Isometry3d(Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()));
  return Isometry3d(Eigen::Translation3d(0.0, 0.0, q));
}

// Whether the shapes of a link replace its meshes in other viewers.
bool is_stand_in(const Robot& robot, int link) {
  return link <= robot.n() && !robot.body(link).draws_solid() && robot.body(link).draws_mesh();
}

}  // namespace

GlbScene robot_scene(const Robot& arm) {
  const Robot& robot = arm.uncoupled();
  const int n = robot.n();
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  GlbScene scene{.materials = looks()};
  scene.nodes.push_back({.name = "base", .T_parent_node = robot.T_world_base()});
  Isometry3d T_link_next = Isometry3d::Identity();  // the row of a joint, after its own motion
  for (int i = 0; i < n; ++i) {
    const Isometry3d T_row = dh_pose(robot.spec().convention, robot.joint(i).dh);
    const double q = robot.home()[i];
    Isometry3d T_before = standard ? T_link_next : T_row;
    if (i == 0) T_before = robot.spec().T_base_first * T_before;
    scene.nodes.push_back({.name = fmt::format("link {}", i + 1),
                           .parent = i,
                           .T_parent_node = T_before * moved_by(robot, i, q),
                           .joint = GlbJoint{.turns = robot.is_revolute(i),
                                             .q = q,
                                             .lower = robot.lower()[i],
                                             .upper = robot.upper()[i]}});
    if (standard) T_link_next = T_row;
  }
  scene.nodes.push_back({.name = "flange", .parent = n, .T_parent_node = T_link_next});
  scene.nodes.push_back(
      {.name = "tool point", .parent = n + 1, .T_parent_node = robot.T_flange_tool()});
  std::vector<std::array<GlbPart, kLooks>> parts(static_cast<std::size_t>(n) + 2);
  for (const LinkShape& shape : link_shapes(robot)) {
    if (!is_stand_in(robot, shape.link))
      add_triangles(shape, parts[static_cast<std::size_t>(shape.link)][look_of(shape.role)]);
  }
  for (int link = 0; link <= n; ++link) {
    const Isometry3d T_node_link = standard && link > 0
                                       ? dh_pose(DhConvention::kStandard, robot.joint(link - 1).dh)
                                       : Isometry3d::Identity();
    for (const LinkMesh& each : robot.body(link).bodies) {
      if (each.use == LinkSolidUse::kCollision) continue;
      add_triangles(*triangles_of(each), T_node_link * each.T_link_mesh,
                    parts[static_cast<std::size_t>(link)][kLight]);
    }
  }
  for (std::size_t link = 0; link < parts.size(); ++link) {
    for (std::size_t look = 0; look < kLooks; ++look) {
      if (parts[link][look].corners.empty()) continue;
      parts[link][look].material = static_cast<int>(look);
      scene.nodes[link].parts.push_back(std::move(parts[link][look]));
    }
  }
  return scene;
}

}  // namespace armlet
