#include "armlet/world/object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

// The size of its bounding box.
Eigen::Vector3d size_of(const Mesh& mesh) { return mesh.triangles->high() - mesh.triangles->low(); }

void check_size(const Object& object, const char* what, double value) {
  const char* expected = nullptr;
  if (!(value > 0.0)) {
    expected = "more than 0 m";
  } else if (value < kSmallest) {
    expected = "0.001 mm at least";
  } else if (value > kLargest) {
    expected = "10 km at most";
  }
  if (expected == nullptr) return;
  throw ArgumentError(fmt::format("The {} of the {} \"{}\" is {} m; expected {}.", what,
                                  shape_name(object.shape), object.name,
                                  std::isnan(value) ? std::abs(value) : value, expected));
}

void check_not_negative(const Object& object, const char* what, double value) {
  if (!std::isfinite(value) || value < 0.0) {
    throw ArgumentError(
        fmt::format("The {} of \"{}\" is {}; expected 0 or more.", what, object.name, value));
  }
}

struct CheckShape {
  const Object& object;
  void operator()(const Box& box) const {
    for (const double side : box.size) check_size(object, "size", side);
  }
  void operator()(const Sphere& sphere) const { check_size(object, "radius", sphere.radius); }
  void operator()(const Plane& plane) const {
    for (const double side : plane.size) check_size(object, "size", side);
  }
  void operator()(const Mesh& mesh) const {
    if (mesh.triangles == nullptr || !mesh.triangles->is_closed())
      throw ArgumentError(fmt::format("\"{}\" needs a closed mesh.", object.name));
    for (const double side : size_of(mesh)) check_size(object, "size", side);
  }
  // For cylinders and cones.
  void operator()(const auto& round) const {
    check_size(object, "radius", round.radius);
    check_size(object, "height", round.height);
  }
};

struct InertiaPerMass {
  // About its own axes; not used for a mesh.
  Eigen::Vector3d operator()(const Mesh&) const { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d operator()(const Box& box) const {
    const Eigen::Vector3d square = box.size.cwiseAbs2();
    return (Eigen::Vector3d::Constant(square.sum()) - square) / 12.0;
  }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    const double r2 = cylinder.radius * cylinder.radius;
    const double across = (3.0 * r2 + cylinder.height * cylinder.height) / 12.0;
    return {across, across, 0.5 * r2};
  }
  Eigen::Vector3d operator()(const Sphere& sphere) const {
    return Eigen::Vector3d::Constant(0.4 * sphere.radius * sphere.radius);
  }
  Eigen::Vector3d operator()(const Cone& cone) const {
    const double r2 = cone.radius * cone.radius;
    const double across = 0.0375 * (4.0 * r2 + cone.height * cone.height);
    return {across, across, 0.3 * r2};
  }
  Eigen::Vector3d operator()(const Plane& plane) const {
    const Eigen::Vector2d square = plane.size.cwiseAbs2();
    return Eigen::Vector3d(square.y(), square.x(), square.sum()) / 12.0;
  }
};

// The extent of a shape along a unit vector of its own axes.
struct WidthAlong {
  Eigen::Vector3d n;
  double operator()(const Box& box) const { return n.cwiseAbs().dot(box.size); }
  double operator()(const Plane& plane) const {
    return n.head<2>().cwiseAbs().dot(Eigen::Vector2d(plane.size));
  }
  double operator()(const Mesh& mesh) const {
    return n.dot(mesh.triangles->farthest(n) - mesh.triangles->farthest(-n));
  }
  double operator()(const Sphere& sphere) const { return 2.0 * sphere.radius; }
  double operator()(const Cylinder& cylinder) const {
    return 2.0 * cylinder.radius * n.head<2>().norm() + cylinder.height * std::abs(n.z());
  }
  // From the tip, or the rim of the base, to the rim on the opposite side.
  double operator()(const Cone& cone) const {
    const double rim = cone.radius * n.head<2>().norm(), tip = cone.height * std::abs(n.z());
    return rim + std::max(rim, tip);
  }
};

struct GraspLine {
  Eigen::Vector3d operator()(const Mesh& mesh) const { return (*this)(Box{size_of(mesh)}); }
  Eigen::Vector3d operator()(const Box& box) const {
    int longest = 0;
    const double length = box.size.maxCoeff(&longest);
    const double next = std::max(box.size[(longest + 1) % 3], box.size[(longest + 2) % 3]);
    return 0.5 * (length - next) * Eigen::Vector3d::Unit(longest);
  }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    return {0.0, 0.0, std::max(0.5 * cylinder.height - cylinder.radius, 0.0)};
  }
  Eigen::Vector3d operator()(const auto&) const { return Eigen::Vector3d::Zero(); }
};

// An inertia is that of a body if its principal values satisfy the triangle inequality.
void check_inertia(const Object& object) {
  if (object.p_obj_com)
    check_finite("the centre of mass of \"" + object.name + "\"", *object.p_obj_com);
  if (!object.inertia_com) return;
  const Eigen::Matrix3d& I = *object.inertia_com;
  const bool is_symmetric = I.allFinite() && (I - I.transpose()).cwiseAbs().maxCoeff() <=
                                                 1e-9 * std::max(I.cwiseAbs().maxCoeff(), 1e-300);
  const Eigen::Matrix3d second = 0.5 * I.trace() * Eigen::Matrix3d::Identity() - I;
  const double slack = 1e-6 * std::max(I.trace(), 0.0);
  const bool is_body =
      is_symmetric && (second + slack * Eigen::Matrix3d::Identity()).llt().info() == Eigen::Success;
  if (is_body || (is_symmetric && I.isZero(0.0))) return;
  throw ArgumentError(
      fmt::format("The inertia of \"{}\" is that of no body: {}.", object.name,
                  is_symmetric ? "one of its principal values is more than the sum of the others"
                               : "it is not symmetric"));
}

}  // namespace

void check_object(const Object& object) {
  if (object.name.empty()) throw ArgumentError("An object needs a name.");
  std::visit(CheckShape{object}, object.shape);
  check_not_negative(object, "mass", object.mass);
  check_not_negative(object, "friction", object.friction);
  check_finite("p_obj_grasp", object.p_obj_grasp);
  if (!std::isfinite(object.stiffness) || !(object.stiffness > 0.0)) {
    throw ArgumentError(fmt::format("The stiffness of \"{}\" is {} N/m; expected more than 0.",
                                    object.name, object.stiffness));
  }
  check_inertia(object);
  check_place(object.name, object.T_world_obj);
}

void check_place(std::string_view name, const Eigen::Isometry3d& T_world_obj) {
  check_pose(fmt::format("the pose of \"{}\"", name), T_world_obj);
  const double farthest = T_world_obj.translation().cwiseAbs().maxCoeff();
  if (farthest <= kLargest) return;
  throw ArgumentError(
      fmt::format("\"{}\" would be {:.6g} km from the origin of the world; expected 10 km at most.",
                  name, 1e-3 * farthest));
}

Eigen::Vector3d center_of_mass(const Object& object) {
  if (object.p_obj_com) return *object.p_obj_com;
  if (const Mesh* mesh = std::get_if<Mesh>(&object.shape))
    return mesh->triangles->mass_properties()->center_of_mass;
  const Cone* cone = std::get_if<Cone>(&object.shape);
  return {0.0, 0.0, cone != nullptr ? -0.25 * cone->height : 0.0};
}

Mesh make_mesh(const TriangleMesh& triangles, double density, std::string file) {
  if (!triangles.is_closed()) throw ArgumentError(triangles.open_because());
  if (!std::isfinite(density) || density < 0.0)
    throw ArgumentError(fmt::format("its density is {} kg/m^3; expected 0 or more", density));
  const Eigen::Vector3d middle = 0.5 * (triangles.low() + triangles.high());
  Mesh mesh{.density = density, .file = std::move(file)};
  mesh.triangles = std::make_shared<const TriangleMesh>(
      triangles.moved(Eigen::Isometry3d(Eigen::Translation3d(-middle))));
  return mesh;
}

namespace {

struct Volume {
  double operator()(const Box& box) const { return box.size.prod(); }
  double operator()(const Sphere& sphere) const {
    return 4.0 / 3.0 * std::numbers::pi * sphere.radius * sphere.radius * sphere.radius;
  }
  double operator()(const Cylinder& cylinder) const {
    return std::numbers::pi * cylinder.radius * cylinder.radius * cylinder.height;
  }
  double operator()(const Cone& cone) const {
    return std::numbers::pi * cone.radius * cone.radius * cone.height / 3.0;
  }
  double operator()(const Plane&) const { return 0.0; }
  double operator()(const Mesh& mesh) const { return mesh.triangles->mass_properties()->volume; }
};

}  // namespace

double volume_of(const Shape& shape) { return std::visit(Volume{}, shape); }

double mass_of(const Shape& shape) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  return mesh == nullptr ? 0.0 : mesh->density * mesh->triangles->mass_properties()->volume;
}

Eigen::Matrix3d inertia(const Object& object) {
  if (object.inertia_com) return *object.inertia_com;
  if (const Mesh* mesh = std::get_if<Mesh>(&object.shape)) {
    const MassProperties& even = *mesh->triangles->mass_properties();
    return object.mass / even.volume * even.inertia;
  }
  return (object.mass * std::visit(InertiaPerMass{}, object.shape)).asDiagonal();
}

double grasp_width(const Object& object, const Eigen::Vector3d& across) {
  return std::visit(WidthAlong{object.T_world_obj.linear().transpose() * across}, object.shape);
}

Eigen::Vector3d grasp_line(const Object& object) { return std::visit(GraspLine{}, object.shape); }

double grasp_distance(const Object& object, const Eigen::Vector3d& p_world) {
  const Eigen::Vector3d p = object.T_world_obj.inverse() * p_world;
  const Eigen::Vector3d half = grasp_line(object);
  const double length = half.norm();
  const double along = length > 0.0 ? std::clamp(p.dot(half) / length, -length, length) : 0.0;
  const Eigen::Vector3d nearest =
      length > 0.0 ? Eigen::Vector3d(along / length * half) : Eigen::Vector3d::Zero();
  return std::min((p - nearest).norm(), (p - object.p_obj_grasp).norm());
}

Eigen::Vector3d grasp_from_above(const Object& object) {
  if (!object.p_obj_grasp.isZero(0.0)) return object.T_world_obj * object.p_obj_grasp;
  const Eigen::Vector3d half = object.T_world_obj.linear() * grasp_line(object);
  const double length = half.norm();
  if (length == 0.0) return object.T_world_obj.translation();
  return object.T_world_obj.translation() + half.z() / length * half;
}

std::string shape_name(const Shape& shape) {
  constexpr const char* kNames[] = {"box", "cylinder", "sphere", "cone", "plane", "mesh"};
  return kNames[shape.index()];
}

}  // namespace armlet
