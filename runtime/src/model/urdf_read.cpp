// Robot descriptions as urdfdom parses them.

#include <fmt/format.h>
#include <urdf_model/model.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "armlet/math/pose.hpp"
#include "armlet/model/serial_arm.hpp"
#include "descriptions/followers.hpp"
#include "descriptions/urdf_faults.hpp"
#include "descriptions/urdf_library.hpp"
#include "descriptions/urdf_meshes.hpp"
#include "descriptions/xml_guard.hpp"
#include "math/snapped_rotation.hpp"
#include "validate.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Error broken(const std::string& what) { return {"urdf", what}; }

Matrix3d R_of(const urdf::Rotation& r) {
  const double norm = r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w;
  const double s = 2.0 / norm;
  Matrix3d R;
  R << 1 - s * (r.y * r.y + r.z * r.z), s * (r.x * r.y - r.z * r.w), s * (r.x * r.z + r.y * r.w),
      s * (r.x * r.y + r.z * r.w), 1 - s * (r.x * r.x + r.z * r.z), s * (r.y * r.z - r.x * r.w),
      s * (r.x * r.z - r.y * r.w), s * (r.y * r.z + r.x * r.w), 1 - s * (r.x * r.x + r.y * r.y);
  return snapped(R);
}

Isometry3d pose_of(const urdf::Pose& pose) {
  return make_pose(R_of(pose.rotation), {pose.position.x, pose.position.y, pose.position.z});
}

Link link_of(const urdf::Link& source) {
  Link link;
  if (source.inertial) {
    const urdf::Inertial& i = *source.inertial;
    const Matrix3d R = R_of(i.origin.rotation);
    Matrix3d I;
    I << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    link.mass = i.mass;
    link.com = Vector3d(i.origin.position.x, i.origin.position.y, i.origin.position.z);
    if (R.isIdentity(0.0)) {
      link.inertia = I;
    } else {
      const Matrix3d turned = R * I * R.transpose();
      link.inertia = 0.5 * (turned + turned.transpose());
    }
  }
  return link;
}

std::optional<LinkSolid> solid_of(const urdf::Geometry& geometry) {
  LinkSolid solid;
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const urdf::Vector3& dim = static_cast<const urdf::Box&>(geometry).dim;
      solid.size = {dim.x, dim.y, dim.z};
      return solid;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      solid.kind = LinkSolidKind::kCylinder;
      solid.size = {cylinder.radius, cylinder.length, 0.0};
      return solid;
    }
    case urdf::Geometry::SPHERE:
      solid.kind = LinkSolidKind::kSphere;
      solid.size = {static_cast<const urdf::Sphere&>(geometry).radius, 0.0, 0.0};
      return solid;
    default:
      return std::nullopt;
  }
}

std::vector<std::string> meshes_of(const urdf::Link& link) {
  std::vector<std::string> names;
  const auto add = [&](const urdf::GeometrySharedPtr& geometry) {
    if (geometry && geometry->type == urdf::Geometry::MESH) {
      names.push_back(static_cast<const urdf::Mesh&>(*geometry).filename);
    }
  };
  for (const auto& visual : link.visual_array) add(visual->geometry);
  for (const auto& collision : link.collision_array) add(collision->geometry);
  return names;
}

// Collects the bodies from the root outwards and their actuators.
class Reader {
 public:
  Reader(const urdf::ModelInterface& model, const UrdfOptions& options)
      : model_(model), options_(options), meshes_(options.load_glb) {
    spec_.name = model.getName();
    spec_.source = "a URDF file";
    spec_.inertia_check = options.inertia_check;
  }

  Result<MechanismSpec> read() {
    const auto root = model_.getRoot();
    if (root == nullptr) return broken("there is no link that all others hang on");
    spec_.base_name = root->name;
    note_meshes(*root);
    Body base{.link = link_of(*root)};
    check_inertia(base);
    if (const auto meshes = meshes_of(*root); !meshes.empty() && !is_missing(meshes.front()))
      base.link.mesh = meshes.front();
    load_bodies(*root, base.link);
    spec_.base = std::move(base.link);
    if (auto error = add_children(*root)) return *error;
    if (auto error = couple()) return *error;
    return std::move(spec_);
  }

 private:
  bool is_missing(const std::string& mesh) const {
    return options_.has_mesh && !options_.has_mesh(mesh);
  }

  // Missing meshes are only noted, since only drawing and collision checks need shapes.
  void note_meshes(const urdf::Link& link) {
    for (const std::string& mesh : meshes_of(link)) {
      const auto [at, is_new] = looked_for_.insert(mesh);
      if (!is_new || !is_missing(mesh)) continue;
      spec_.notes.push_back(
          fmt::format("the mesh \"{}\" of link `{}` is not there; the link has no shape of its own "
                      "(--package NAME=DIR and ROS_PACKAGE_PATH say where packages are)",
                      mesh, link.name));
    }
  }

  // Mass, centre and inertia that no body has are ignored: only forces need them.
  void check_inertia(Body& body) const {
    Link inertial;
    inertial.mass = body.link.mass;
    inertial.com = body.link.com;
    inertial.inertia = body.link.inertia;
    body.inertia_fault = link_fault(inertial, options_.inertia_check);
    if (body.inertia_fault.empty()) return;
    if (options_.inertia_check == InertiaCheck::kRigidBody &&
        link_fault(inertial, InertiaCheck::kPublished).empty())
      body.inertia_fault +=
          " (inertias: \"published\" in a program, --published in the command, keep it)";
    body.link = without_mass(body.link);
  }

  // The shapes for collision checks and those for drawing. If a link has usable shapes of only one
  // kind, they serve both purposes.
  void load_bodies(const urdf::Link& link, Link& body) {
    for (const auto& each : link.collision_array)
      add_shape(link, body, *each, LinkSolidUse::kCollision);
    const LinkSolidUse use = body.has_shape() ? LinkSolidUse::kPicture : LinkSolidUse::kBoth;
    for (const auto& each : link.visual_array) add_shape(link, body, *each, use);
    if (body.draws_solid() || body.draws_mesh()) return;
    for (LinkSolid& each : body.solids) each.use = LinkSolidUse::kBoth;
    for (LinkMesh& each : body.bodies) each.use = LinkSolidUse::kBoth;
  }

  // Adds a visual or a collision element. A shape that is already there for the other use serves
  // both.
  void add_shape(const urdf::Link& link, Link& body, const auto& element, LinkSolidUse use) {
    if (!element.geometry) return;
    const Isometry3d T = pose_of(element.origin);
    if (element.geometry->type == urdf::Geometry::MESH) {
      const auto& mesh = static_cast<const urdf::Mesh&>(*element.geometry);
      return add_mesh(link, body, mesh, T, use);
    }
    auto solid = solid_of(*element.geometry);
    if (!solid) return;
    solid->T_link_solid = T;
    solid->use = use;
    const auto same = std::ranges::find_if(body.solids, [&](const LinkSolid& each) {
      return each.use != use && each.kind == solid->kind && each.size == solid->size &&
             each.T_link_solid.matrix() == T.matrix();
    });
    if (same == body.solids.end()) return body.solids.push_back(*solid);
    same->use = LinkSolidUse::kBoth;
  }

  void add_mesh(const urdf::Link& link, Link& body, const urdf::Mesh& given, const Isometry3d& T,
                LinkSolidUse use) {
    if (is_missing(given.filename)) return;
    const Vector3d factors(given.scale.x, given.scale.y, given.scale.z);
    Result<LinkMesh> mesh = use == LinkSolidUse::kPicture ? meshes_.picture(given.filename, factors)
                                                          : meshes_.body(given.filename, factors);
    if (!mesh.ok()) {
      const std::string note = fmt::format("the mesh \"{}\" of link `{}` cannot be used: {}",
                                           given.filename, link.name, mesh.error().message);
      if (std::ranges::find(spec_.notes, note) == spec_.notes.end()) spec_.notes.push_back(note);
      return;
    }
    if (!mesh->triangles && !mesh->picture.bytes) return;
    const auto same = std::ranges::find_if(body.bodies, [&](const LinkMesh& each) {
      return each.use != use && each.triangles == mesh->triangles &&
             each.T_link_mesh.matrix() == T.matrix();
    });
    if (same != body.bodies.end()) {
      same->use = LinkSolidUse::kBoth;
      return;
    }
    LinkMesh placed = std::move(mesh).value();
    placed.T_link_mesh = T;
    placed.use = use;
    body.bodies.push_back(std::move(placed));
  }

  // From the root outwards without recursion, since chains may be long.
  std::optional<Error> add_children(const urdf::Link& root) {
    std::vector<std::pair<const urdf::Link*, int>> open{{&root, -1}};
    while (!open.empty()) {
      const auto [link, index] = open.back();
      open.pop_back();
      std::vector<std::pair<const urdf::Link*, int>> found;
      for (const auto& joint : link->child_joints) {
        const auto child = model_.getLink(joint->child_link_name);
        if (auto error = add_body(*joint, *child, index)) return error;
        found.emplace_back(child.get(), static_cast<int>(spec_.bodies.size()) - 1);
      }
      open.insert(open.end(), found.rbegin(), found.rend());
    }
    return std::nullopt;
  }

  std::optional<Error> add_body(const urdf::Joint& joint, const urdf::Link& child, int parent) {
    note_meshes(child);
    Body body{.name = child.name,
              .joint_name = joint.name,
              .parent = parent,
              .T_parent_joint = pose_of(joint.parent_to_joint_origin_transform),
              .axis = Vector3d(joint.axis.x, joint.axis.y, joint.axis.z),
              .link = link_of(child)};
    const std::vector<std::string> meshes = meshes_of(child);
    if (!meshes.empty() && !is_missing(meshes.front())) body.link.mesh = meshes.front();
    check_inertia(body);
    load_bodies(child, body.link);
    switch (joint.type) {
      case urdf::Joint::FIXED:
        break;
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        body.joint = BodyJoint::kRevolute;
        break;
      case urdf::Joint::PRISMATIC:
        body.joint = BodyJoint::kPrismatic;
        break;
      default:
        return broken(fmt::format(
            "joint `{}` floats or moves in a plane; the joints of an arm turn, slide or are "
            "fixed",
            joint.name));
    }
    if (body.joint != BodyJoint::kFixed) {
      if (joint.dynamics) {
        const double friction = joint.dynamics->friction;
        body.link.friction = {joint.dynamics->damping, friction, -friction};
      }
      joints_.push_back(&joint);
    }
    if (joint.mimic && joint.limits && joint.type != urdf::Joint::CONTINUOUS) {
      body.copy_limits = {.lower = joint.limits->lower,
                          .upper = joint.limits->upper,
                          .max_speed = joint.limits->velocity};
    }
    spec_.bodies.push_back(std::move(body));
    return std::nullopt;
  }

  static Actuator actuator_of(const urdf::Joint& joint) {
    Actuator actuator{.name = joint.name};
    if (joint.type == urdf::Joint::CONTINUOUS) {
      actuator.lower = -kNoLimit;
      actuator.upper = kNoLimit;
    }
    if (!joint.limits) return actuator;
    if (joint.type != urdf::Joint::CONTINUOUS) {
      actuator.lower = joint.limits->lower;
      actuator.upper = joint.limits->upper;
    }
    actuator.max_speed = joint.limits->velocity;
    actuator.max_effort = joint.limits->effort;
    return actuator;
  }

  // Follows a mimic joint to its independent source: value = ratio q + shift.
  struct Followed {
    const urdf::Joint* joint;
    double ratio = 1.0, shift = 0.0;
  };
  Result<Followed> follow(const urdf::Joint& joint) const {
    Followed at{&joint};
    for (std::size_t steps = 0; at.joint->mimic; ++steps) {
      const urdf::JointMimic& mimic = *at.joint->mimic;
      const auto next = model_.getJoint(mimic.joint_name);
      if (next == nullptr) {
        return broken(fmt::format("joint `{}` copies `{}`, which does not exist", at.joint->name,
                                  mimic.joint_name));
      }
      if (steps > joints_.size()) {
        return broken(fmt::format("joint `{}` copies itself through other joints", joint.name));
      }
      at.shift += at.ratio * mimic.offset;
      at.ratio *= mimic.multiplier;
      at.joint = next.get();
    }
    return at;
  }

  std::optional<Error> couple() {
    std::map<const urdf::Joint*, Eigen::Index> column;
    for (const urdf::Joint* joint : joints_) {
      if (joint->mimic) continue;
      column.emplace(joint, static_cast<Eigen::Index>(spec_.actuators.size()));
      spec_.actuators.push_back(actuator_of(*joint));
    }
    const auto rows = static_cast<Eigen::Index>(joints_.size());
    spec_.coupling = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(spec_.actuators.size()));
    spec_.offset = Eigen::VectorXd::Zero(rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
      const urdf::Joint& joint = *joints_[static_cast<std::size_t>(row)];
      const Result<Followed> followed = follow(joint);
      if (!followed.ok()) return followed.error();
      const auto found = column.find(followed->joint);
      if (found == column.end()) {
        return broken(fmt::format("joint `{}` copies `{}`, which is fixed", joint.name,
                                  followed->joint->name));
      }
      spec_.coupling(row, found->second) = followed->ratio;
      spec_.offset[row] = followed->shift;
    }
    return std::nullopt;
  }

  const urdf::ModelInterface& model_;
  const UrdfOptions& options_;
  MechanismSpec spec_;
  std::set<std::string> looked_for_;  // meshes whose existence was checked
  UrdfMeshes meshes_;
  std::vector<const urdf::Joint*> joints_;  // moving joints, in the order of the bodies
};

// The model of a text, or the reason why there is none.
Result<std::shared_ptr<urdf::ModelInterface>> model_of(std::string_view text) {
  if (const std::string fault = xml_fault(text); !fault.empty()) return broken(fault);
  // Checked first, since links in a circle would keep each other in memory for ever.
  if (const std::string fault = structure_fault(text); !fault.empty()) return broken(fault);
  if (const std::string fault = xacro_fault(text); !fault.empty()) return broken(fault);
  ParsedUrdf parsed = parse_urdf(std::string(text));
  // urdfdom reports some errors and continues without what it could not read.
  if (parsed.model == nullptr || !parsed.reason.empty()) {
    if (const std::string fault = number_fault(text); !fault.empty()) return broken(fault);
    return broken(
        fmt::format("the robot description cannot be read: {}",
                    parsed.reason.empty() ? "there is no element <robot>" : parsed.reason));
  }
  return std::move(parsed.model);
}

UrdfPart part_of(const urdf::Geometry& geometry, const urdf::Pose& origin,
                 const urdf::MaterialSharedPtr& material) {
  UrdfPart part{.T_link_part = pose_of(origin)};
  if (const auto solid = solid_of(geometry)) {
    part.solid = *solid;
  } else {
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    part.mesh = mesh.filename;
    part.scale = {mesh.scale.x, mesh.scale.y, mesh.scale.z};
  }
  if (material) {
    const auto byte = [](float c) {
      return static_cast<int>(std::lround(255.0 * std::min(std::max(double{c}, 0.0), 1.0)));
    };
    const urdf::Color& c = material->color;
    part.color = fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
  }
  return part;
}

std::vector<UrdfPart> parts_of(const urdf::Link& link) {
  std::vector<UrdfPart> parts;
  for (const auto& each : link.visual_array) {
    if (each->geometry) parts.push_back(part_of(*each->geometry, each->origin, each->material));
  }
  if (!parts.empty()) return parts;
  for (const auto& each : link.collision_array) {
    if (each->geometry) parts.push_back(part_of(*each->geometry, each->origin, nullptr));
  }
  return parts;
}

}  // namespace

Result<std::vector<UrdfLink>> read_urdf_scene(std::string_view text) {
  const auto model = model_of(text);
  if (!model.ok()) return model.error();
  const auto root = (*model)->getRoot();
  if (root == nullptr) return broken("there is no link that all others hang on");
  std::vector<UrdfLink> links;
  const auto add = [&](const urdf::Link& link, int parent, bool is_free, const Isometry3d& T) {
    links.push_back({.name = link.name,
                     .parent = is_free ? -1 : parent,
                     .is_free = is_free,
                     .T_world_link = T,
                     .link = link_of(link),
                     .parts = parts_of(link)});
  };
  std::vector<std::pair<const urdf::Link*, int>> open{{root.get(), 0}};
  add(*root, -1, false, Isometry3d::Identity());
  while (!open.empty()) {
    const auto [link, index] = open.back();
    open.pop_back();
    for (const auto& joint : link->child_joints) {
      const bool is_free = joint->type == urdf::Joint::FLOATING;
      if (joint->type != urdf::Joint::FIXED && !is_free) {
        return broken(
            fmt::format("joint `{}` moves; a world has only joints that are fixed or "
                        "float, a robot is declared by a program: urdf(\"...\")",
                        joint->name));
      }
      const auto child = (*model)->getLink(joint->child_link_name);
      const Isometry3d T = links[static_cast<std::size_t>(index)].T_world_link *
                           pose_of(joint->parent_to_joint_origin_transform);
      add(*child, index, is_free, T);
      open.emplace_back(child.get(), static_cast<int>(links.size()) - 1);
    }
  }
  return links;
}

Result<Mechanism> read_urdf(std::string_view text, const UrdfOptions& options) {
  const auto model = model_of(text);
  if (!model.ok()) return model.error();
  Result<MechanismSpec> spec = Reader(**model, options).read();
  if (!spec.ok()) return spec.error();
  try {
    return Mechanism(std::move(spec).value());
  } catch (const ArgumentError& error) {
    return broken(error.what());
  }
}

Result<RobotSpec> serial_arm_of_urdf(std::string_view text, const UrdfOptions& options,
                                     std::string_view tip) {
  const Result<Mechanism> mechanism = read_urdf(text, options);
  if (!mechanism.ok()) return mechanism.error();
  return serial_arm(*mechanism, tip);
}

}  // namespace armlet
