#include "camera/raster/shadow_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "camera/raster/clip.hpp"

namespace armlet::raster {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d box_corner(const Surface& surface, int i) {
  return {(i & 1) != 0 ? surface.high().x() : surface.low().x(),
          (i & 2) != 0 ? surface.high().y() : surface.low().y(),
          (i & 4) != 0 ? surface.high().z() : surface.low().z()};
}

}  // namespace

// A rectangle across the light.
struct ShadowMap::Extent {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::max());
  Vector2d high = Vector2d::Constant(std::numeric_limits<double>::lowest());

  void add(const Vector3d& p, const LightFrame& light) {
    const Vector2d at(dot(p, light.x), dot(p, light.y));
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  [[nodiscard]] Extent common(const Extent& other) const {
    return {low.cwiseMax(other.low), high.cwiseMin(other.high)};
  }
  [[nodiscard]] bool is_empty() const { return !(low.x() < high.x() && low.y() < high.y()); }
};

// The rectangle around the bodies that cast shadows, as far as it is above what the camera may see
// of it: the viewing pyramid up to the farthest body or shadow on the ground.
bool ShadowMap::choose_part(const Scene& scene, const View& view, const LightFrame& light) {
  Extent bodies, seen;
  const Intrinsics& camera = view.camera;
  double farthest = camera.near;
  const bool has_ground = scene.ground.drawn && light.towards.z() > 1e-3;
  for (const SceneBody& body : scene.bodies) {
    for (int i = 0; i < 8; ++i) {
      const Vector3d p = body.T_world_body * box_corner(*body.surface, i);
      if (body.casts_shadow) bodies.add(p, light);
      farthest = std::max(farthest, (view.T_eye_world * p).z());
      const double height = p.z() - scene.ground.z;
      if (!has_ground || height <= 0.0) continue;
      const Vector3d shadow = p - light.towards * (height / light.towards.z());
      farthest = std::max(farthest, (view.T_eye_world * shadow).z());
    }
  }
  farthest = std::min(farthest, camera.far);
  for (int i = 0; i < 8; ++i) {
    const double z = (i & 4) != 0 ? farthest : camera.near;
    const double u = (i & 1) != 0 ? camera.width : -1.0, v = (i & 2) != 0 ? camera.height : -1.0;
    seen.add(view.T_world_eye *
                 Vector3d(z * (u - camera.cx) / camera.fx, z * (v - camera.cy) / camera.fy, z),
             light);
  }
  const Extent part = bodies.common(seen);
  if (part.is_empty()) return false;
  constexpr int kBorder = 2;
  const int most = std::clamp(std::max(camera.width, camera.height) * 8 / 5, 64, kMostSquares);
  const Vector2d size = part.high - part.low;
  square_ = std::max(size.x(), size.y()) / (most - 2 * kBorder);
  square_ = std::max(square_, 1e-6);
  corner_ = part.low - Vector2d::Constant(kBorder * square_);
  columns_ = std::min(most, static_cast<int>(size.x() / square_) + 2 * kBorder + 1);
  grid_ = {0, 0, kOne, columns_,
           std::min(most, static_cast<int>(size.y() / square_) + 2 * kBorder + 1)};
  return true;
}

void ShadowMap::draw(const Scene& scene, const View& view, const LightFrame& light) {
  columns_ = 0;
  if (!choose_part(scene, view, light)) return;
  rows_.resize(grid_.columns, grid_.rows, false);
  std::fill_n(rows_.nearness.begin(), rows_.stride * static_cast<std::size_t>(grid_.rows), -1e30F);
  last_x_ = static_cast<float>(grid_.columns - 1);
  last_y_ = static_cast<float>(grid_.rows - 1);
  bias_ = static_cast<float>(0.75 * square_ + 5e-5);
  for (const SceneBody& body : scene.bodies) {
    if (body.casts_shadow) draw_body(body, light);
  }
  const Eigen::Matrix3d R = view.T_eye_world.linear();
  const Vector3d eye = view.T_world_eye.translation();
  x_ = view.along_ray(R * light.x / square_);
  y_ = view.along_ray(R * light.y / square_);
  h_ = view.along_ray(R * light.towards);
  origin_ = {(dot(eye, light.x) - corner_.x()) / square_,
             (dot(eye, light.y) - corner_.y()) / square_, dot(eye, light.towards)};
}

void ShadowMap::draw_body(const SceneBody& body, const LightFrame& light) {
  const SurfaceParts& parts = body.surface->parts();
  const Eigen::Matrix3d& R = body.T_world_body.linear();
  const Vector3d t = body.T_world_body.translation();
  const std::array<Vector3d, 3> axes{light.x / square_, light.y / square_, light.towards};
  std::array<Vector3d, 3> rows;
  for (std::size_t k = 0; k < 3; ++k) rows[k] = R.transpose() * axes[k];
  const Vector3d shift(dot(t, axes[0]) - corner_.x() / square_,
                       dot(t, axes[1]) - corner_.y() / square_, dot(t, axes[2]));
  const auto placed = [&](const Vector3d& p) {
    return Vector3d(dot(rows[0], p) + shift[0], dot(rows[1], p) + shift[1],
                    dot(rows[2], p) + shift[2]);
  };
  const Vector3d middle = placed(body.surface->middle());
  const double r = body.surface->radius() / square_ + 1.0;
  if (middle.x() + r < 0.0 || middle.x() - r > grid_.columns || middle.y() + r < 0.0 ||
      middle.y() - r > grid_.rows)
    return;
  points_.resize(parts.positions.size());
  for (std::size_t i = 0; i < points_.size(); ++i) points_[i] = placed(parts.positions[i]);
  for (std::size_t i = 0; i < parts.corners.size(); ++i) add_triangle(parts, i);
}

// Axes x, y across and h towards the light are a right-handed frame: triangles that face the light
// are counterclockwise there, with y upwards.
void ShadowMap::add_triangle(const SurfaceParts& parts, std::size_t i) {
  const auto& corners = parts.corners[i];
  const std::array<Vector3d, 3> p{points_[corners[0]], points_[corners[1]], points_[corners[2]]};
  const Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]);
  const bool is_from_edge = std::abs(n.z()) <= 1e-12 * (std::abs(n.x()) + std::abs(n.y()));
  if (is_from_edge || (parts.closed && n.z() < 0.0)) return;
  const auto [low_x, high_x] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
  const auto [low_y, high_y] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
  if (high_x < 0.0 || low_x > grid_.columns || high_y < 0.0 || low_y > grid_.rows) return;
  if (low_x >= kGuardLow && high_x <= kGuardHigh && low_y >= kGuardLow && high_y <= kGuardHigh) {
    fill_part(p, p[0], n);
    return;
  }
  Polygon polygon{.p = {p[0], p[1], p[2]}, .size = 3};
  for (const HalfSpace& side :
       {HalfSpace{{1.0, 0.0, 0.0}, -kGuardLow}, HalfSpace{{-1.0, 0.0, 0.0}, kGuardHigh},
        HalfSpace{{0.0, 1.0, 0.0}, -kGuardLow}, HalfSpace{{0.0, -1.0, 0.0}, kGuardHigh}})
    polygon = cut(polygon, side);
  for (int k = 2; k < polygon.size; ++k) {
    const auto at = static_cast<std::size_t>(k);
    fill_part({polygon.p[0], polygon.p[at - 1], polygon.p[at]}, p[0], n);
  }
}

// A part of the plane through p with normal n.
void ShadowMap::fill_part(const std::array<Vector3d, 3>& corners, const Vector3d& p,
                          const Vector3d& n) {
  DrawnTriangle t{};
  for (std::size_t k = 0; k < 3; ++k) {
    t.corners.x[k] = to_fixed(corners[k].x());
    t.corners.y[k] = to_fixed(corners[k].y());
  }
  const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
  t.low = static_cast<float>(low);
  t.high = static_cast<float>(high);
  t.a = -n.x() / n.z();
  t.b = -n.y() / n.z();
  t.c = p.z() - t.a * p.x() - t.b * p.y();
  fill<false>(t, grid_, 0, grid_.rows, rows_);
}

}  // namespace armlet::raster
