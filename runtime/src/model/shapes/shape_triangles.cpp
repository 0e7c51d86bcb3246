#include "model/shapes/shape_triangles.hpp"

#include <numbers>

#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kFaces = 32;   // of a full circle
constexpr int kQuarter = 8;  // of a quarter

// A point of a surface's profile and the normal there; x is the distance from the axis, y along it.
struct ProfilePoint {
  Vector2d p;
  Vector2d n;
};

class Surface {
 public:
  Surface(const Eigen::Isometry3d& T_link_shape, GlbPart& part) : T_(T_link_shape), part_(part) {}

  // Adds the surface of revolution of the profile from `from` to `to`; the outside is on its right.
  void turn(const ProfilePoint& from, const ProfilePoint& to) {
    for (int k = 0; k < kFaces; ++k) {
      const std::uint32_t a = put(from, k), b = put(from, k + 1), c = put(to, k + 1),
                          d = put(to, k);
      if (from.p.x() > 0.0) face(a, b, c);
      if (to.p.x() > 0.0) face(a, c, d);
    }
  }
  // Adds a straight part of the profile.
  void straight(const Vector2d& from, const Vector2d& to) {
    const Vector2d way = (to - from).normalized();
    const Vector2d n(way.y(), -way.x());
    turn({from, n}, {to, n});
  }

  void quad(const Vector3d& middle, const Vector3d& right, const Vector3d& up) {
    const Vector3d n = right.cross(up).normalized();
    const std::uint32_t a = put(middle - right - up, n), b = put(middle + right - up, n),
                        c = put(middle + right + up, n), d = put(middle - right + up, n);
    face(a, b, c);
    face(a, c, d);
  }

 private:
  std::uint32_t put(const Vector3d& p, const Vector3d& n) {
    part_.positions.emplace_back((T_ * p).cast<float>());
    part_.normals.emplace_back((T_.linear() * n).cast<float>());
    return static_cast<std::uint32_t>(part_.positions.size() - 1);
  }
  std::uint32_t put(const ProfilePoint& point, int k) {
    const double angle = 2.0 * std::numbers::pi * (k % kFaces) / kFaces;
    const double c = det::cos(angle), s = det::sin(angle);
    return put({point.p.x() * c, point.p.x() * s, point.p.y()},
               {point.n.x() * c, point.n.x() * s, point.n.y()});
  }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    part_.corners.insert(part_.corners.end(), {a, b, c});
  }

  const Eigen::Isometry3d& T_;
  GlbPart& part_;
};

// Adds half a sphere; side -1: from the lower pole to its equator, 1: from the equator to the upper
// pole.
void half_sphere(Surface& surface, double radius, double z, double side) {
  const auto at = [&](int j) {
    const int from_pole = side < 0.0 ? j : kQuarter - j;
    const double angle = 0.5 * std::numbers::pi * from_pole / kQuarter;
    const Vector2d n = from_pole == kQuarter ? Vector2d(1.0, 0.0)
                                             : Vector2d(det::sin(angle), side * det::cos(angle));
    return ProfilePoint{Vector2d(0.0, z) + radius * n, n};
  };
  for (int j = 0; j < kQuarter; ++j) surface.turn(at(j), at(j + 1));
}

void box(Surface& surface, const Vector3d& half) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d out = half[axis] * Vector3d::Unit(axis);
    const Vector3d right = half[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
    const Vector3d up = half[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
    surface.quad(out, right, up);
    surface.quad(-out, up, right);
  }
}

}  // namespace

void add_triangles(const LinkShape& shape, GlbPart& part) {
  Surface surface(shape.T_link_shape, part);
  const double r = shape.radius, h = 0.5 * shape.length;
  switch (shape.kind) {
    case LinkShapeKind::kBox:
      box(surface, 0.5 * shape.size);
      break;
    case LinkShapeKind::kCylinder:
      surface.straight({0.0, -h}, {r, -h});
      surface.straight({r, -h}, {r, h});
      surface.straight({r, h}, {0.0, h});
      break;
    case LinkShapeKind::kCapsule:
      half_sphere(surface, r, -h, -1.0);
      if (h > 0.0) surface.straight({r, -h}, {r, h});
      half_sphere(surface, r, h, 1.0);
      break;
    case LinkShapeKind::kRing: {
      const double inner = r - shape.thickness;
      surface.straight({inner, -h}, {r, -h});
      surface.straight({r, -h}, {r, h});
      surface.straight({r, h}, {inner, h});
      surface.straight({inner, h}, {inner, -h});
      break;
    }
  }
}

}  // namespace armlet
