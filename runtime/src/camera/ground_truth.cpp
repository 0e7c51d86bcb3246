#include "armlet/camera/ground_truth.hpp"

#include <cmath>
#include <limits>

#include "armlet/camera/renderer.hpp"
#include "armlet/core/checkpoint.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

// Parameter of the first intersection of a ray, in the body's frame, with one of its triangles, at
// most t.
double hit(const Surface& surface, const Vector3d& p, const Vector3d& d, double t) {
  const SurfaceParts& parts = surface.parts();
  const Vector3d to_middle = surface.middle() - p;
  const double square = d.squaredNorm(), along = to_middle.dot(d) / square;
  const double r = surface.radius() * (1.0 + 1e-9) + 1e-12;
  if ((to_middle - along * d).squaredNorm() > r * r || along * std::sqrt(square) < -r) return t;
  for (const auto& corners : parts.corners) {
    const Vector3d& a = parts.positions[corners[0]];
    const Vector3d u = parts.positions[corners[1]] - a, v = parts.positions[corners[2]] - a;
    const Vector3d h = d.cross(v);
    const double det = u.dot(h);  // positive if the ray comes from outside
    if (det == 0.0 || (parts.closed && det < 0.0)) continue;
    const Vector3d s = p - a, q = s.cross(u);
    const double x = s.dot(h) / det, y = d.dot(q) / det, at = v.dot(q) / det;
    if (x >= 0.0 && y >= 0.0 && x + y <= 1.0 && at > 0.0 && at < t) t = at;
  }
  return t;
}

std::optional<RayHit> nearest(const Scene& scene, const Vector3d& p, const Vector3d& d) {
  RayHit first{.t = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    checkpoint(20 * body.surface->parts().corners.size());
    const Eigen::Isometry3d T_body_world = body.T_world_body.inverse(Eigen::Isometry);
    const double t = hit(*body.surface, T_body_world * p, T_body_world.linear() * d, first.t);
    if (t < first.t) first = {t, static_cast<int>(i)};
  }
  const double height = p.z() - scene.ground.z;
  if (scene.ground.drawn && height > 0.0 && d.z() < 0.0 && -height / d.z() < first.t)
    first = {-height / d.z(), kGroundBody};
  if (std::isinf(first.t)) return std::nullopt;
  return first;
}

}  // namespace

std::optional<RayHit> first_hit(const Scene& scene, const Vector3d& p, const Vector3d& d) {
  check_scene(scene);
  check_finite("start of the ray", p);
  check_finite("direction of the ray", d);
  if (d.squaredNorm() == 0.0)
    throw ArgumentError("The direction of a ray is (0, 0, 0); expected a vector.");
  return nearest(scene, p, d);
}

std::vector<SeenCorner> seen_corners(const Scene& scene, const Pinhole& camera,
                                     const Eigen::Isometry3d& T_world_eye, int body) {
  constexpr double kNearly = 1.0 - 1e-5;
  check_scene(scene);
  check_pose("camera", T_world_eye);
  check_body(scene, body);
  const SceneBody& wanted = scene.bodies[static_cast<std::size_t>(body)];
  const Eigen::Isometry3d T_eye_world = T_world_eye.inverse(Eigen::Isometry);
  const Vector3d eye = T_world_eye.translation();
  const std::vector<Vector3d>& features = wanted.surface->parts().features;
  std::vector<SeenCorner> seen;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Vector3d p = wanted.T_world_body * features[i];
    const Vector3d in_eye = T_eye_world * p;
    const Result<Eigen::Vector2d> pixel = camera.project(in_eye);
    if (!pixel || !camera.is_inside(pixel.value()) || in_eye.z() > camera.intrinsics().far)
      continue;
    const std::optional<RayHit> first = nearest(scene, eye, p - eye);
    if (!first || first->t >= kNearly) seen.push_back({static_cast<int>(i), pixel.value()});
  }
  return seen;
}

}  // namespace armlet
