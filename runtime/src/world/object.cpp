#include "armlet/world/object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

void check_size_above_zero(const Object& object, const char* what, double value) {
  if (!std::isfinite(value) || !(value > 0.0)) {
    throw ArgumentError(fmt::format("The {} of the {} \"{}\" is {} m; expected more than 0 m.",
                                    what, shape_name(object.shape), object.name, value));
  }
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
    for (const double side : box.size) check_size_above_zero(object, "size", side);
  }
  void operator()(const Cylinder& cylinder) const {
    check_size_above_zero(object, "radius", cylinder.radius);
    check_size_above_zero(object, "height", cylinder.height);
  }
  void operator()(const Sphere& sphere) const {
    check_size_above_zero(object, "radius", sphere.radius);
  }
};

struct InertiaPerMass {
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
};

// Widths along the object's axes, seen along the axis that is nearest to the approach.
struct GraspWidth {
  Eigen::Vector3d approach;  // in the object's axes
  double operator()(const Box& box) const {
    int along = 0;
    approach.cwiseAbs().maxCoeff(&along);
    return std::min(box.size[(along + 1) % 3], box.size[(along + 2) % 3]);
  }
  double operator()(const Cylinder& cylinder) const {
    const bool from_above = std::abs(approach.z()) >= approach.head<2>().norm();
    const double across = 2.0 * cylinder.radius;
    return from_above ? across : std::min(across, cylinder.height);
  }
  double operator()(const Sphere& sphere) const { return 2.0 * sphere.radius; }
};

struct GraspLine {
  Eigen::Vector3d operator()(const Box& box) const {
    int longest = 0;
    const double length = box.size.maxCoeff(&longest);
    const double next = std::max(box.size[(longest + 1) % 3], box.size[(longest + 2) % 3]);
    return 0.5 * (length - next) * Eigen::Vector3d::Unit(longest);
  }
  Eigen::Vector3d operator()(const Cylinder& cylinder) const {
    return {0.0, 0.0, std::max(0.5 * cylinder.height - cylinder.radius, 0.0)};
  }
  Eigen::Vector3d operator()(const Sphere&) const { return Eigen::Vector3d::Zero(); }
};

}  // namespace

void check_object(const Object& object) {
  if (object.name.empty()) throw ArgumentError("An object needs a name.");
  std::visit(CheckShape{object}, object.shape);
  check_not_negative(object, "mass", object.mass);
  check_not_negative(object, "friction", object.friction);
  check_finite("p_obj_grasp", object.p_obj_grasp);
  check_pose(fmt::format("the pose of \"{}\"", object.name), object.T_world_obj);
}

Eigen::Matrix3d inertia(const Object& object) {
  return (object.mass * std::visit(InertiaPerMass{}, object.shape)).asDiagonal();
}

double grasp_width(const Object& object, const Eigen::Vector3d& approach) {
  return std::visit(GraspWidth{object.T_world_obj.linear().transpose() * approach}, object.shape);
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
  constexpr const char* kNames[] = {"box", "cylinder", "sphere"};
  return kNames[shape.index()];
}

}  // namespace armlet
