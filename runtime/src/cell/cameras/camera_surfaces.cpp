#include "cell/cameras/camera_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "armlet/camera/colors.hpp"
#include "armlet/camera/surfaces.hpp"
#include "armlet/core/checkpoint.hpp"
#include "armlet/image/files.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "armlet/model/robot_scene.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

LinearRgb color_of(const std::string& name) {
  return color_named(name).value_or(*color_named("gray"));
}

// The links of a robot from robot_scene with their surfaces; made once for each robot.
struct LinkSurfaces {
  using FromShape = void;

  struct Node {
    GlbNode frame;  // without triangles
    std::shared_ptr<const Surface> surface{};
  };
  std::vector<Node> nodes;
  std::vector<Material> materials;

  explicit LinkSurfaces(const Robot& robot) {
    GlbScene scene = robot_scene(robot);
    for (const GlbMaterial& look : scene.materials) {
      materials.push_back(
          {.color = {static_cast<float>(look.color[0]), static_cast<float>(look.color[1]),
                     static_cast<float>(look.color[2])}});
    }
    for (GlbNode& each : scene.nodes) {
      Node node;
      if (!each.parts.empty())
        node.surface = std::make_shared<const Surface>(surface_of(each.parts));
      each.parts.clear();
      node.frame = std::move(each);
      nodes.push_back(std::move(node));
    }
  }
};

// The pose change of a node when its joint value becomes q.
Isometry3d moved(const GlbNode& node, double q) {
  const double by = q - node.joint->q;
  if (node.joint->turns)
    return node.T_parent_node * Isometry3d(rotation_exp(by * Vector3d::UnitZ()));
  return node.T_parent_node * Isometry3d(Eigen::Translation3d(0.0, 0.0, by));
}

void add_robot(const Cell& cell, int index, std::vector<SceneBody>& bodies) {
  const CellRobot& robot = cell.robot(index);
  const auto& links = robot.model->derived<LinkSurfaces>();
  const JointVector values = row_values(*robot.model, robot.q);
  std::vector<Isometry3d> poses;
  int row = 0;
  for (const LinkSurfaces::Node& node : links.nodes) {
    const Isometry3d T_parent_node = node.frame.joint && row < values.size()
                                         ? moved(node.frame, values[row++])
                                         : node.frame.T_parent_node;
    poses.push_back(node.frame.parent < 0
                        ? cell.T_world_base(index)
                        : poses[static_cast<std::size_t>(node.frame.parent)] * T_parent_node);
    if (node.surface == nullptr) continue;
    bodies.push_back({.name = fmt::format("{} {}", robot.name, node.frame.name),
                      .surface = node.surface,
                      .T_world_body = poses.back(),
                      .materials = links.materials});
  }
}

// Adds a surface scaled along its axes and moved along z.
void add(SurfaceParts& to, const Shape& shape, const Vector3d& scale, double along) {
  const Surface surface = surface_of(shape);
  const SurfaceParts& from = surface.parts();
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  for (const Vector3d& p : from.positions)
    to.positions.push_back(p.cwiseProduct(scale) + along * Vector3d::UnitZ());
  for (const Eigen::Vector3f& n : from.normals)
    to.normals.push_back(n.cwiseQuotient(scale.cast<float>()).normalized());
  for (const auto& corners : from.corners)
    to.corners.push_back({first + corners[0], first + corners[1], first + corners[2]});
}

// The sizes are those of the page.
SurfaceParts parts_of(DrawingKind kind, const Vector3d& size) {
  SurfaceParts parts;
  const Vector3d same = Vector3d::Ones();
  switch (kind) {
    case DrawingKind::kArrow: {
      constexpr double kHeadLong = 3.2, kHeadWide = 1.3, kHeadMost = 0.5, kLeastWide = 0.75;
      const double head = std::min(kHeadLong * size[1], kHeadMost * size[0]);
      const double wide = std::max(kHeadWide * head / kHeadLong, kLeastWide * size[1]);
      const double rod = size[0] - 0.9 * head;
      add(parts, Cylinder{0.5 * size[1], rod}, same, 0.5 * rod);
      add(parts, Cone{wide, head}, same, size[0] - 0.5 * head);
      break;
    }
    case DrawingKind::kLine:
      add(parts, Cylinder{0.5 * size[1], size[0]}, same, 0.5 * size[0]);
      break;
    case DrawingKind::kDisk:
      add(parts, Cylinder{size[0], 1e-4}, same, 0.0);
      break;
    case DrawingKind::kEllipsoid:
      add(parts, Sphere{1.0}, size, 0.0);
      break;
    case DrawingKind::kCapsule:
      add(parts, Cylinder{size[0], size[1]}, same, 0.5 * size[1]);
      add(parts, Sphere{size[0]}, same, 0.0);
      add(parts, Sphere{size[0]}, same, size[1]);
      break;
    case DrawingKind::kText:
      break;
  }
  return parts;
}

}  // namespace

const SceneBody& Cameras::Surfaces::body_of(const Object& object) {
  const auto found = objects_.find(object.name);
  if (found != objects_.end() && found->second.shape == object.shape &&
      found->second.color == object.color && found->second.texture == object.texture) {
    found->second.scene = scene_;
    return found->second.body;
  }
  const Material plain{.color = color_of(object.color)};
  SceneBody body{.name = object.name,
                 .surface = std::make_shared<const Surface>(surface_of(object.shape)),
                 .materials = {plain, plain}};
  if (object.texture != nullptr) {
    // Decoded once, perhaps for a page: the steps of a program do not depend on it.
    const Supervised nobody(nullptr);
    // An object whose texture cannot be decoded has its plain colour.
    if (const Result<Image> picture = read_image(*object.texture); picture.ok())
      body.materials[kPicturedMaterial] = {.color = {1.0F, 1.0F, 1.0F},
                                           .texture = std::make_shared<const Texture>(*picture)};
  }
  KeptObject kept{object.shape, object.color, object.texture, std::move(body), scene_};
  return objects_.insert_or_assign(object.name, std::move(kept)).first->second.body;
}

const SceneBody* Cameras::Surfaces::body_of(const Drawing& drawing) {
  const auto found = drawings_.find(drawing.name);
  if (found != drawings_.end() && found->second.kind == drawing.kind &&
      found->second.size == drawing.size && found->second.color == drawing.color) {
    found->second.scene = scene_;
    return &found->second.body;
  }
  SurfaceParts parts = parts_of(drawing.kind, drawing.size);
  if (parts.corners.empty()) return nullptr;
  SceneBody body{.name = drawing.name,
                 .surface = std::make_shared<const Surface>(std::move(parts)),
                 .materials = {Material{.color = color_of(drawing.color)}},
                 .casts_shadow = false};
  KeptDrawing kept{drawing.kind, drawing.size, drawing.color, std::move(body), scene_};
  return &drawings_.insert_or_assign(drawing.name, std::move(kept)).first->second.body;
}

std::vector<SceneBody> Cameras::Surfaces::bodies_of(const Cell& cell) {
  std::vector<SceneBody> bodies;
  ++scene_;
  const World& world = cell.world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    bodies.push_back(body_of(world.object(i)));
    bodies.back().T_world_body = world.object(i).T_world_obj;
  }
  for (int i = 0; i < cell.robot_count(); ++i) add_robot(cell, i, bodies);
  for (const std::string& name : cell.drawings().names()) {
    const SceneBody* body = body_of(*cell.drawings().find(name));
    if (body == nullptr) continue;
    bodies.push_back(*body);
    bodies.back().T_world_body = cell.T_world_drawing(name);
  }
  const auto is_gone = [this](const auto& kept) { return kept.second.scene != scene_; };
  std::erase_if(objects_, is_gone);
  std::erase_if(drawings_, is_gone);
  return bodies;
}

}  // namespace armlet
