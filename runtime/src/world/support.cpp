#include "world/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace armlet {
namespace {

// Least overlap with which a flat face carries another one: a smaller one is touching sides and
// rounding.
constexpr double kOverlap = 1e-6;  // m
// cos of the largest angle at which an axis counts as vertical or horizontal.
constexpr double kUpright = 1.0 - 1e-9;

// A body projected along z: a rectangle or a point, enlarged by a flat radius (cylinder) or a round
// one (sphere), and its half height.
struct Footprint {
  Eigen::Vector2d centre{0.0, 0.0};
  Eigen::Vector2d axis{1.0, 0.0};       // of the rectangle's first side
  Eigen::Vector2d half_size{0.0, 0.0};  // zero: a point
  double flat_radius = 0.0;
  double round_radius = 0.0;
  double half_height = 0.0;

  [[nodiscard]] bool is_point() const { return half_size.isZero(0.0); }
  [[nodiscard]] Eigen::Vector2d across() const { return {-axis.y(), axis.x()}; }
};

// A box with a vertical axis has its exact rectangle; any other box has its bounding rectangle.
Footprint box_footprint(const Eigen::Matrix3d& R, const Eigen::Vector3d& half) {
  Footprint print;
  for (int up = 0; up < 3; ++up) {
    if (std::abs(R(2, up)) < kUpright) continue;
    const int first = (up + 1) % 3;
    print.axis = R.col(first).head<2>().normalized();
    print.half_size = {half[first], half[(up + 2) % 3]};
    print.half_height = half[up];
    return print;
  }
  const Eigen::Vector3d extent = R.cwiseAbs() * half;
  print.half_size = extent.head<2>();
  print.half_height = extent.z();
  return print;
}

struct MakeFootprint {
  const Eigen::Matrix3d& R;
  Footprint operator()(const Box& box) const { return box_footprint(R, 0.5 * box.size); }
  // The bounding box.
  Footprint operator()(const Mesh& mesh) const {
    return box_footprint(R, 0.5 * (mesh.triangles->high() - mesh.triangles->low()));
  }
  Footprint operator()(const Plane& plane) const {
    return box_footprint(R, {0.5 * plane.size.x(), 0.5 * plane.size.y(), 0.0});
  }
  // The bounding cylinder.
  Footprint operator()(const Cone& cone) const {
    return (*this)(Cylinder{cone.radius, cone.height});
  }
  Footprint operator()(const Cylinder& cylinder) const {
    const double r = cylinder.radius;
    const double h = 0.5 * cylinder.height;
    if (std::abs(R(2, 2)) >= kUpright) {
      return {.flat_radius = r, .half_height = h};
    }
    if (std::abs(R(2, 2)) > 1e-6) return box_footprint(R, {r, r, h});
    // A lying cylinder: the axis is horizontal, and a rotation about it changes nothing.
    return {.axis = R.col(2).head<2>().normalized(), .half_size = {h, r}, .half_height = r};
  }
  Footprint operator()(const Sphere& sphere) const {
    return {.round_radius = sphere.radius, .half_height = sphere.radius};
  }
};

Footprint footprint(const Object& object) {
  Footprint print = std::visit(MakeFootprint{object.T_world_obj.linear()}, object.shape);
  print.centre = object.T_world_obj.translation().head<2>();
  return print;
}

// Distance of a point from a rectangle, negative inside.
double point_gap(const Eigen::Vector2d& p, const Footprint& rectangle) {
  const Eigen::Vector2d d = p - rectangle.centre;
  const Eigen::Vector2d q =
      Eigen::Vector2d(std::abs(d.dot(rectangle.axis)), std::abs(d.dot(rectangle.across()))) -
      rectangle.half_size;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

// Largest gap between two rectangles along their four side directions (separating axes): negative
// exactly if they overlap.
double rectangle_gap(const Footprint& a, const Footprint& b) {
  const auto reach = [](const Footprint& print, const Eigen::Vector2d& along) {
    return std::abs(print.axis.dot(along)) * print.half_size.x() +
           std::abs(print.across().dot(along)) * print.half_size.y();
  };
  double gap = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& along : std::array{a.axis, a.across(), b.axis, b.across()}) {
    const double apart = std::abs((b.centre - a.centre).dot(along));
    gap = std::max(gap, apart - reach(a, along) - reach(b, along));
  }
  return gap;
}

double gap_between(const Footprint& a, const Footprint& b) {
  const double flat = a.flat_radius + b.flat_radius;
  if (a.is_point() && b.is_point()) return (a.centre - b.centre).norm() - flat;
  if (a.is_point()) return point_gap(a.centre, b) - flat;
  if (b.is_point()) return point_gap(b.centre, a) - flat;
  return rectangle_gap(a, b);
}

}  // namespace

bool has_plain_footprint(const Object& object) {
  const Eigen::Matrix3d R = object.T_world_obj.linear();
  if (std::holds_alternative<Sphere>(object.shape)) return true;
  if (std::holds_alternative<Box>(object.shape) || std::holds_alternative<Plane>(object.shape))
    return R.row(2).cwiseAbs().maxCoeff() >= kUpright;
  return std::holds_alternative<Cylinder>(object.shape) && std::abs(R(2, 2)) >= kUpright;
}

namespace {

// For tilted bodies.
struct Lowest {
  Eigen::Vector3d up;  // in the frame of the body
  double operator()(const Box& box) const { return up.cwiseAbs().dot(0.5 * box.size); }
  double operator()(const Plane& plane) const {
    return up.head<2>().cwiseAbs().dot(0.5 * plane.size);
  }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Mesh& mesh) const { return -up.dot(mesh.triangles->farthest(-up)); }
  double operator()(const Cylinder& cylinder) const {
    return cylinder.radius * up.head<2>().norm() + 0.5 * cylinder.height * std::abs(up.z());
  }
  double operator()(const Cone& cone) const {
    const double base = cone.radius * up.head<2>().norm() + 0.5 * cone.height * up.z();
    return std::max(base, -0.5 * cone.height * up.z());
  }
};

}  // namespace

double half_height(const Object& object) {
  if (has_plain_footprint(object)) return footprint(object).half_height;
  return std::visit(Lowest{object.T_world_obj.linear().row(2).transpose()}, object.shape);
}

namespace {

// Half of the diagonal of the bounding box of a shape; for a ball its radius.
struct Diagonal {
  double operator()(const Box& box) const { return 0.5 * box.size.norm(); }
  double operator()(const Plane& plane) const { return 0.5 * plane.size.norm(); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Mesh& mesh) const {
    return 0.5 * (mesh.triangles->high() - mesh.triangles->low()).norm();
  }
  // For cylinders and cones.
  double operator()(const auto& round) const {
    return Eigen::Vector3d(round.radius, round.radius, 0.5 * round.height).norm();
  }
};

}  // namespace

// A tilted body counts as its bounding box along the world's axes, whose sides are at most as long
// as the diagonal.
double resting_reach(const Shape& shape) {
  const double half = std::visit(Diagonal{}, shape);
  return std::holds_alternative<Sphere>(shape) ? half : std::numbers::sqrt3 * half;
}

namespace {

struct Core {
  double operator()(const Box& box) const { return 0.5 * box.size.minCoeff(); }
  double operator()(const Plane&) const { return 0.0; }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Mesh&) const { return -std::numeric_limits<double>::infinity(); }
  double operator()(const Cylinder& cylinder) const {
    return std::min(cylinder.radius, 0.5 * cylinder.height);
  }
  // Half of the height, up to the tip or down to the base, and across to the rim.
  double operator()(const Cone& cone) const {
    const double side = 0.5 * cone.radius * cone.height / std::hypot(cone.radius, cone.height);
    return std::min(0.5 * cone.height, side);
  }
};

}  // namespace

double resting_core(const Shape& shape) { return std::visit(Core{}, shape); }

std::optional<double> resting_height(const Object& falling, const Object& below) {
  const Footprint upper = footprint(falling);
  const Footprint lower = footprint(below);
  const double gap = gap_between(upper, lower);
  const double round = upper.round_radius + lower.round_radius;
  if (gap > round - kOverlap) return std::nullopt;
  // A sphere's centre is above an edge at the horizontal distance g by sqrt(r^2 - g^2), above a
  // face by r.
  const double aside = std::max(gap, 0.0);
  const double rise = std::sqrt(std::max(round * round - aside * aside, 0.0));
  const double flat_upper = upper.round_radius > 0.0 ? 0.0 : upper.half_height;
  const double flat_lower = lower.round_radius > 0.0 ? 0.0 : lower.half_height;
  return below.T_world_obj.translation().z() + flat_lower + rise + flat_upper;
}

}  // namespace armlet
