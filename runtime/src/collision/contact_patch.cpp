#include "collision/contact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/math/det_math.hpp"
#include "collision/difference.hpp"

namespace armlet {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Polygon = std::vector<Vector2d>;

constexpr double kFlat = 2e-6;  // m, difference in height from one end to the other

double toward(double size, double d) { return d < 0.0 ? -size : size; }

// The feature of a box or a segment, in its own frame; edges of constant height belong to it.
std::vector<Vector3d> straight_feature(const Vector3d& half, const Vector3d& d) {
  std::vector<Vector3d> points = {
      {toward(half.x(), d.x()), toward(half.y(), d.y()), toward(half.z(), d.z())}};
  for (int axis = 0; axis < 3; ++axis) {
    if (half[axis] == 0.0 || 2.0 * half[axis] * std::abs(d[axis]) > kFlat) continue;
    // The second half in reverse order, so that the corners go round the face.
    for (std::size_t i = points.size(); i-- > 0;) {
      points.push_back(points[i]);
      points.back()[axis] = -points.back()[axis];
    }
  }
  return points;
}

constexpr int kCorners = 64;

std::vector<Vector3d> disc(double radius, double z) {
  std::vector<Vector3d> points;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCorners;
    points.emplace_back(radius * det::cos(angle), radius * det::sin(angle), z);
  }
  return points;
}

// The feature of a cylinder or a cone, in its own frame.
ContactPatch round_feature(const Solid& solid, const Vector3d& d) {
  const double r = solid.half.x(), h = solid.half.z();
  const bool is_cone = solid.core == Solid::Core::kCone;
  const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
  if (2.0 * r * across <= kFlat && (!is_cone || d.z() < 0.0)) {
    const double z = toward(h, d.z());
    return {.points = disc(r, z), .centre = {0.0, 0.0, z}, .radius = r};
  }
  const Vector3d out(d.x() / across, d.y() / across, 0.0);
  const Vector3d bottom =
      across > 0.0 ? Vector3d(r * out - h * Vector3d::UnitZ()) : Vector3d(0.0, 0.0, -h);
  const Vector3d top =
      is_cone || across == 0.0 ? Vector3d(0.0, 0.0, h) : Vector3d(r * out + h * Vector3d::UnitZ());
  const double rise = (top - bottom).dot(d);
  if (std::abs(rise) <= kFlat) return {.points = {bottom, top}};
  return {.points = {rise > 0.0 ? top : bottom}};
}

// The convex hull of the vertices of a mesh with the largest height along d (the chains of A. M.
// Andrew 1979).
ContactPatch mesh_feature(const Solid& solid, const Vector3d& d) {
  const double height = core_support(solid, d).dot(d) - kFlat;
  std::vector<Vector3d> high;
  for (const Vector3d& each : solid.mesh->vertices()) {
    if (each.dot(d) >= height) high.push_back(each);
  }
  if (high.size() < 3) return {.points = high};
  const Vector3d u = d.unitOrthogonal(), v = d.normalized().cross(u);
  const auto seen = [&](const Vector3d& p) { return Vector2d(p.dot(u), p.dot(v)); };
  std::ranges::sort(high, [&](const Vector3d& p, const Vector3d& q) {
    const Vector2d a = seen(p), b = seen(q);
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  const auto turns_left = [&](const Vector3d& p, const Vector3d& q, const Vector3d& r) {
    const Vector2d a = seen(q) - seen(p), b = seen(r) - seen(p);
    return a.x() * b.y() - a.y() * b.x() > 1e-14;
  };
  std::vector<Vector3d> around;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = around.size();
    for (const Vector3d& each : high) {
      while (around.size() >= begin + 2 && !turns_left(*(around.end() - 2), around.back(), each))
        around.pop_back();
      around.push_back(each);
    }
    around.pop_back();
    std::ranges::reverse(high);
  }
  return {.points = around};
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

// The part of a polygon, or of a segment, inside a convex polygon with counterclockwise corners
// (Sutherland and Hodgman 1974).
Polygon clipped(Polygon subject, const Polygon& window) {
  constexpr double kOnEdge = 1e-12;  // m^2
  for (std::size_t k = 0; k < window.size(); ++k) {
    const Vector2d &from = window[k], edge = window[(k + 1) % window.size()] - from;
    const auto side = [&](const Vector2d& p) {
      return edge.x() * (p - from).y() - edge.y() * (p - from).x() + kOnEdge;
    };
    Polygon kept;
    const std::size_t n = subject.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d &p = subject[i], &q = subject[(i + 1) % n];
      const double at_p = side(p), at_q = side(q);
      if (at_p >= 0.0) kept.push_back(p);
      if ((at_p >= 0.0) != (at_q >= 0.0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    subject = std::move(kept);
  }
  return subject;
}

// The centre of area, or the midpoint of the two farthest points if the area is zero.
Vector2d middle_of(const Polygon& polygon) {
  constexpr double kNoArea = 1e-14;  // m^2
  const double area = area_of(polygon);
  if (area < kNoArea) {
    Vector2d low = polygon.front(), high = polygon.front();
    const auto order = [](const Vector2d& p, const Vector2d& q) {
      return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y());
    };
    for (const Vector2d& p : polygon) {
      if (order(p, low)) low = p;
      if (order(high, p)) high = p;
    }
    return 0.5 * (low + high);
  }
  // Relative to the first corner, so that no digits are lost far from the origin.
  const Vector2d origin = polygon.front();
  Vector2d sum = Vector2d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d p = polygon[i] - origin, q = polygon[(i + 1) % polygon.size()] - origin;
    sum += (p + q) * (p.x() * q.y() - p.y() * q.x());
  }
  return origin + sum / (6.0 * area);
}

// For two edges: the middle of their overlap if they are parallel, otherwise their intersection.
std::optional<Vector2d> middle_of_edges(const Polygon& first, const Polygon& second) {
  const Vector2d a = first[1] - first[0], b = second[1] - second[0], apart = second[0] - first[0];
  const double length = a.norm();
  const double turn = a.x() * b.y() - a.y() * b.x();
  if (std::abs(turn) > 1e-9 * length * b.norm()) {
    const double s = (apart.x() * b.y() - apart.y() * b.x()) / turn;
    return Vector2d(first[0] + std::clamp(s, 0.0, 1.0) * a);
  }
  const double u = apart.dot(a) / (length * length), v = u + b.dot(a) / (length * length);
  const double low = std::max(0.0, std::min(u, v)), high = std::min(1.0, std::max(u, v));
  if (low > high) return std::nullopt;
  return Vector2d(first[0] + 0.5 * (low + high) * a);
}

// Whether a disc lies inside a convex polygon with counterclockwise corners, or in another disc.
bool holds_disc(const ContactPatch& face, const Polygon& outline, const Vector2d& face_centre,
                const Vector2d& centre, double radius) {
  if (face.radius > 0.0) return (centre - face_centre).norm() + radius <= face.radius;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector2d &from = outline[k], edge = outline[(k + 1) % outline.size()] - from;
    const Vector2d d = centre - from;
    if (edge.x() * d.y() - edge.y() * d.x() < radius * edge.norm()) return false;
  }
  return outline.size() > 2;
}

}  // namespace

ContactPatch contact_patch(const Solid& solid, const Vector3d& along) {
  const Vector3d d = solid.T.linear().transpose() * along;
  const bool is_round = solid.core == Solid::Core::kCylinder || solid.core == Solid::Core::kCone;
  ContactPatch patch = solid.mesh != nullptr ? mesh_feature(solid, d)
                       : is_round            ? round_feature(solid, d)
                                  : ContactPatch{.points = straight_feature(solid.half, d)};
  for (Vector3d& point : patch.points) point = solid.T * point + solid.margin * along;
  patch.centre = solid.T * patch.centre + solid.margin * along;
  return patch;
}

std::optional<Vector3d> middle_of_both(const ContactPatch& first, const ContactPatch& second,
                                       const Vector3d& n) {
  const Vector3d &origin = first.points.front(), u = n.unitOrthogonal(), v = n.cross(u);
  const auto seen = [&](const Vector3d& p) {
    return Vector2d((p - origin).dot(u), (p - origin).dot(v));
  };
  const auto on_first = [&](const Vector2d& p) { return Vector3d(origin + p.x() * u + p.y() * v); };
  if (first.points.size() == 1) return origin;
  if (second.points.size() == 1) return on_first(seen(second.points.front()));
  const auto outline = [&](const ContactPatch& patch) {
    Polygon polygon;
    for (const Vector3d& p : patch.points) polygon.push_back(seen(p));
    if (area_of(polygon) < 0.0) std::ranges::reverse(polygon);
    return polygon;
  };
  const Polygon a = outline(first), b = outline(second);
  if (a.size() == 2 && b.size() == 2) {
    const auto middle = middle_of_edges(a, b);
    return middle ? std::optional(on_first(*middle)) : std::nullopt;
  }
  const Vector2d centre_a = seen(first.centre), centre_b = seen(second.centre);
  if (first.radius > 0.0 && holds_disc(second, b, centre_b, centre_a, first.radius))
    return on_first(centre_a);
  if (second.radius > 0.0 && holds_disc(first, a, centre_a, centre_b, second.radius))
    return on_first(centre_b);
  const Polygon common = b.size() == 2 ? clipped(b, a) : clipped(a, b);
  if (common.empty()) return std::nullopt;
  return on_first(middle_of(common));
}

}  // namespace armlet
