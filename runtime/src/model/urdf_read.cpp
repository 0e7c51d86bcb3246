// The only door to urdfdom. Its library is loaded when the first robot description is read: it
// brings four more shared libraries, which no other program should wait for.

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_model/model.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "armlet/core/platform.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/serial_arm.hpp"
#include "math/snapped_rotation.hpp"
#include "urdf_faults.hpp"
#include "xml_guard.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Keeps what urdfdom would print.
class Capture : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || text.empty()) return;
    if (first_.empty()) first_ = text;
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

// urdf::parseURDF, and where console_bridge sends what it reports.
struct Library {
  std::shared_ptr<urdf::ModelInterface> (*parse)(const std::string&) = nullptr;
  void (*use_handler)(console_bridge::OutputHandler*) = nullptr;
  void (*restore_handler)() = nullptr;
  std::string missing;
};

const Library& library() {
  static const Library loaded = [] {
    Library found;
    const LoadedLibrary urdfdom(ARMLET_URDFDOM_LIBRARY);
    const auto find = [&](auto& function, const char* symbol) {
      using Function = std::remove_reference_t<decltype(function)>;
      function = reinterpret_cast<Function>(urdfdom.find(symbol));
      if (function == nullptr) found.missing = ARMLET_URDFDOM_LIBRARY;
    };
    find(found.parse, "_ZN4urdf9parseURDFERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE");
    find(found.use_handler, "_ZN14console_bridge16useOutputHandlerEPNS_13OutputHandlerE");
    find(found.restore_handler, "_ZN14console_bridge28restorePreviousOutputHandlerEv");
    return found;
  }();
  return loaded;
}

struct Parsed {
  std::shared_ptr<urdf::ModelInterface> model;
  std::string reason;
};

// The handler of console_bridge belongs to the process: one text at a time.
Parsed parse(const std::string& text) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  Parsed parsed;
  if (!library().missing.empty()) {
    parsed.reason = fmt::format(
        "robot descriptions are read by the library {}, which is not installed (Debian: "
        "liburdfdom-model3.0)",
        library().missing);
    return parsed;
  }
  Capture capture;
  library().use_handler(&capture);
  try {
    parsed.model = library().parse(text);
  } catch (const std::exception& error) {
    parsed.reason = error.what();
  }
  library().restore_handler();
  if (!capture.first().empty()) parsed.reason = capture.first();
  return parsed;
}

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

struct PlacedMesh {
  std::string file;
  Isometry3d T_link_mesh;
  Vector3d scale;
};

// Those that are compared with other bodies.
std::vector<PlacedMesh> collision_meshes_of(const urdf::Link& link) {
  std::vector<PlacedMesh> found;
  const auto add = [&](const urdf::GeometrySharedPtr& geometry, const urdf::Pose& origin) {
    if (!geometry || geometry->type != urdf::Geometry::MESH) return;
    const auto& mesh = static_cast<const urdf::Mesh&>(*geometry);
    found.push_back({mesh.filename, pose_of(origin), {mesh.scale.x, mesh.scale.y, mesh.scale.z}});
  };
  for (const auto& each : link.collision_array) add(each->geometry, each->origin);
  if (!link.collision_array.empty()) return found;
  for (const auto& each : link.visual_array) add(each->geometry, each->origin);
  return found;
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

// Collects the bodies from the root outwards and what drives them.
class Reader {
 public:
  Reader(const urdf::ModelInterface& model, const UrdfOptions& options)
      : model_(model), options_(options) {
    spec_.name = model.getName();
    spec_.source = "a URDF file";
    spec_.inertia_check = options.inertia_check;
  }

  Result<MechanismSpec> read() {
    const auto root = model_.getRoot();
    if (root == nullptr) return broken("there is no link that all others hang on");
    spec_.base_name = root->name;
    if (auto error = check_meshes(*root)) return *error;
    spec_.base = link_of(*root);
    if (const auto meshes = meshes_of(*root); !meshes.empty()) spec_.base.mesh = meshes.front();
    if (auto error = load_bodies(*root, spec_.base)) return *error;
    if (auto error = add_children(*root)) return *error;
    if (auto error = couple()) return *error;
    return std::move(spec_);
  }

 private:
  std::optional<Error> check_meshes(const urdf::Link& link) const {
    if (!options_.has_mesh) return std::nullopt;
    for (const std::string& mesh : meshes_of(link)) {
      if (options_.has_mesh(mesh)) continue;
      return broken(fmt::format("the mesh \"{}\" of link `{}` is not there", mesh, link.name));
    }
    return std::nullopt;
  }

  // Boxes, cylinders and spheres among what is compared with other bodies, and meshes.
  std::optional<Error> load_bodies(const urdf::Link& link, Link& body) const {
    // Pictures show the shapes for collisions where those for pictures are meshes, or none.
    const bool is_apart =
        !link.collision_array.empty() && !link.visual_array.empty() && meshes_of(link).empty();
    const auto add = [&](const auto& element, LinkSolidUse use) {
      auto solid = element.geometry ? solid_of(*element.geometry) : std::nullopt;
      if (!solid) return;
      solid->T_link_solid = pose_of(element.origin);
      if (is_apart) solid->use = use;
      const auto same = std::ranges::find_if(body.solids, [&](const LinkSolid& each) {
        return each.use != use && each.kind == solid->kind && each.size == solid->size &&
               each.T_link_solid.matrix() == solid->T_link_solid.matrix();
      });
      if (same == body.solids.end()) return body.solids.push_back(*solid);
      same->use = LinkSolidUse::kBoth;
    };
    for (const auto& each : link.collision_array) add(*each, LinkSolidUse::kCollision);
    for (const auto& each : link.visual_array) {
      if (is_apart || link.collision_array.empty()) add(*each, LinkSolidUse::kPicture);
    }
    if (!options_.load_mesh) return std::nullopt;
    for (const PlacedMesh& each : collision_meshes_of(link)) {
      auto mesh = options_.load_mesh(each.file);
      if (!mesh.ok()) {
        return broken(fmt::format("the mesh \"{}\" of link `{}` cannot be used: {}", each.file,
                                  link.name, mesh.error().message));
      }
      if (*mesh == nullptr) continue;
      try {
        body.bodies.push_back(
            {each.scale == Vector3d::Ones()
                 ? *mesh
                 : std::make_shared<const TriangleMesh>((*mesh)->scaled(each.scale)),
             each.T_link_mesh});
      } catch (const ArgumentError& error) {
        return broken(fmt::format("the mesh \"{}\" of link `{}` cannot be used: {}", each.file,
                                  link.name, error.what()));
      }
    }
    return std::nullopt;
  }

  // From the root outwards without recursion: chains may be long.
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
    if (auto error = check_meshes(child)) return error;
    Body body{.name = child.name,
              .joint_name = joint.name,
              .parent = parent,
              .T_parent_joint = pose_of(joint.parent_to_joint_origin_transform),
              .axis = Vector3d(joint.axis.x, joint.axis.y, joint.axis.z),
              .link = link_of(child)};
    const std::vector<std::string> meshes = meshes_of(child);
    if (!meshes.empty()) body.link.mesh = meshes.front();
    if (auto error = load_bodies(child, body.link)) return error;
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
    spec_.bodies.push_back(std::move(body));
    return std::nullopt;
  }

  static Actuator actuator_of(const urdf::Joint& joint) {
    constexpr double kRevolution = 6.283185307179586;
    Actuator actuator{.name = joint.name};
    if (joint.type == urdf::Joint::CONTINUOUS) {
      actuator.lower = -kRevolution;
      actuator.upper = kRevolution;
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

  // Follows a mimic joint to the one that moves on its own: value = ratio q + shift.
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
  std::vector<const urdf::Joint*> joints_;  // those that move, in the order of the bodies
};

// Why a text is none; the model if it is one.
Result<std::shared_ptr<urdf::ModelInterface>> model_of(std::string_view text) {
  if (const std::string fault = xml_fault(text); !fault.empty()) return broken(fault);
  // urdfdom would hold on to links in a circle for ever.
  if (const std::string fault = structure_fault(text); !fault.empty()) return broken(fault);
  Parsed parsed = parse(std::string(text));
  // urdfdom reports some faults and goes on without what it could not read.
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
