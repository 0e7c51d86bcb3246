#include "armlet/world/object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
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

std::string shape_name(const Shape& shape) {
  constexpr const char* kNames[] = {"box", "cylinder", "sphere"};
  return kNames[shape.index()];
}

}  // namespace armlet
