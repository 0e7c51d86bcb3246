#include "armlet/collision/contact.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "collision/contact_patch.hpp"
#include "collision/difference.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

// The largest coordinate of a body along a direction of the world.
double extent(const Solid& solid, const Vector3d& n) {
  const Vector3d d = solid.T.linear().transpose() * n;
  const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
  const double reach = solid.T.translation().dot(n) + solid.margin;
  switch (solid.core) {
    case Solid::Core::kPoint:
    case Solid::Core::kSegment:
    case Solid::Core::kBox:
      break;
    case Solid::Core::kHull:
    case Solid::Core::kTriangle:
    case Solid::Core::kMesh:
      return reach + core_support(solid, d).dot(d);
    case Solid::Core::kCylinder:
      return reach + across * solid.half.x() + std::abs(d.z()) * solid.half.z();
    case Solid::Core::kCone:
      return reach +
             std::max(d.z() * solid.half.z(), across * solid.half.x() - d.z() * solid.half.z());
  }
  return reach + d.cwiseAbs().dot(solid.half);
}

// Width of the slab across n that separates both, with `a` on the side to which n points; if
// negative, their depth along n.
double slab(const Solid& a, const Solid& b, const Vector3d& n) {
  return -extent(a, -n) - extent(b, n);
}

// The normal of the face of a hull whose direction is that of `n` to 1e-6, towards a.
//
// is_a  whether the hull is a.
std::optional<Vector3d> face_normal(const Solid& hull, bool is_a, const Vector3d& n) {
  const Vector3d out = hull.T.linear().transpose() * (is_a ? Vector3d(-n) : n);
  const TriangleMesh& mesh = *hull.mesh;
  const double height = mesh.farthest(out).dot(out);
  constexpr double kFlat = 1e-8;  // m
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    if (mesh.corner(i, 0).dot(out) < height - kFlat ||
        mesh.corner(i, 1).dot(out) < height - kFlat || mesh.corner(i, 2).dot(out) < height - kFlat)
      continue;
    const Vector3d face = (mesh.corner(i, 1) - mesh.corner(i, 0))
                              .cross(mesh.corner(i, 2) - mesh.corner(i, 0))
                              .normalized();
    if (face.dot(out) > 1.0 - 1e-9) return hull.T.linear() * (is_a ? Vector3d(-face) : face);
  }
  return std::nullopt;
}

}  // namespace

Vector3d contact_normal(const Solid& a, const Solid& b) {
  constexpr double kAsGood = 1e-8;  // m
  const Gap gap = gap_between(a, b);
  double widest = gap.distance - kAsGood;
  Vector3d normal = gap.away;
  if (!a.is_convex() || !b.is_convex()) return normal;
  for (const Solid* body : {&a, &b}) {
    const bool is_box = body->core == Solid::Core::kBox;
    if (body->core == Solid::Core::kHull) {
      if (const auto n = face_normal(*body, body == &a, normal)) normal = *n;
      continue;
    }
    const bool has_cap = body->core == Solid::Core::kCylinder || body->core == Solid::Core::kCone;
    for (int axis = is_box ? 0 : 2; axis < 3 && (is_box || has_cap); ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const Vector3d n = sign * body->T.linear().col(axis);
        const double width = slab(a, b, n);
        if (width <= widest) continue;
        widest = width;
        normal = n;
      }
    }
  }
  return normal;
}

double depth_along(const Solid& a, const Solid& b, const Vector3d& n) {
  // A body that is not convex may move back by the gap only.
  const bool is_convex = a.is_convex() && b.is_convex();
  const int most_steps = is_convex ? 60 : 400;
  constexpr double kExact = 1e-10;  // m
  double depth = -slab(a, b, n);
  Solid moved = a;
  // After this displacement they touch at most. As long as there is a gap the displacement can be
  // reduced by that gap, measured along n.
  for (int step = 0; step < most_steps && depth > 0.0; ++step) {
    moved.T.translation() = a.T.translation() + depth * n;
    const Gap gap = gap_between(moved, b);
    const double rate = is_convex ? gap.away.dot(n) : 1.0;
    if (gap.distance <= kExact || rate <= 0.0) break;
    depth -= gap.distance / rate;
  }
  return std::max(depth, 0.0);
}

Vector3d pressure_point(const Solid& a, const Solid& b, const Vector3d& n) {
  if (a.is_convex() && b.is_convex()) {
    const ContactPatch lower = contact_patch(a, -n), upper = contact_patch(b, n);
    if (const auto common = middle_of_both(lower, upper, n)) return *common;
  }
  Solid free = a;
  free.T.translation() += depth_along(a, b, n) * n;
  return gap_between(free, b).p_a + a.T.translation() - free.T.translation();
}

}  // namespace armlet
