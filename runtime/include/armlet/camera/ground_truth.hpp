#pragma once
// Exact answers about what a camera sees, from the scene itself instead of its picture.

#include <optional>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Distance to the first triangle, or the ground, on a ray: p + t d, t > 0; nothing if there is
// none. Closed bodies are hit from outside only, as they are drawn.
//
// p, d    in the world, m; d of any length but zero.
// body    the number of the body, kGroundBody for the ground.
// throws  ArgumentError as check_scene, and for numbers that are not finite or d = 0.
// source  T. Moeller and B. Trumbore, Fast, minimum storage ray-triangle intersection, Journal of
//         Graphics Tools 2(1), 1997.
struct RayHit {
  double t = 0.0;
  int body = 0;
};
std::optional<RayHit> first_hit(const Scene& scene, const Eigen::Vector3d& p,
                                const Eigen::Vector3d& d);

// A feature of a body that is in the picture and not hidden.
//
// number  among the features of its surface, from 0.
// pixel   exact, not rounded.
struct SeenCorner {
  int number = 0;
  Eigen::Vector2d pixel{0.0, 0.0};
};

// Features of a body that are not hidden; a surface nearer by up to 10 millionths of their distance
// does not hide them.
//
// body    number in the scene.
// throws  ArgumentError as Renderer::visible_share.
std::vector<SeenCorner> seen_corners(const Scene& scene, const Pinhole& camera,
                                     const Eigen::Isometry3d& T_world_eye, int body);

}  // namespace armlet
