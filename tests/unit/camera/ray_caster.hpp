// What a ray meets, computed without anything of the rasteriser.
#pragma once

#include <cmath>
#include <limits>

#include "armlet/camera/scene.hpp"

namespace armlet::test {

struct Met {
  double t = std::numeric_limits<double>::infinity();
  int body = -1;
  std::size_t triangle = 0;
  Eigen::Vector3d n = Eigen::Vector3d::Zero();  // against the ray
  bool operator==(const Met& other) const {
    return body == other.body && triangle == other.triangle;
  }
};

// The first triangle that is met beyond t = `from`: by the plane and the sides of its edges. -2 is
// the ground.
inline Met cast(const Scene& scene, const Eigen::Vector3d& p, const Eigen::Vector3d& d,
                double from = 1e-9, bool shadow = false) {
  Met first;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (shadow && !body.casts_shadow) continue;
    const SurfaceParts& parts = body.surface->parts();
    for (std::size_t k = 0; k < parts.corners.size(); ++k) {
      std::array<Eigen::Vector3d, 3> c;
      for (std::size_t j = 0; j < 3; ++j)
        c[j] = body.T_world_body * parts.positions[parts.corners[k][j]];
      const Eigen::Vector3d n = (c[1] - c[0]).cross(c[2] - c[0]);
      const double along = n.dot(d);
      if (along == 0.0 || (parts.closed && along > 0.0 && !shadow)) continue;
      const double t = n.dot(c[0] - p) / along;
      if (t <= from || t >= first.t) continue;
      const Eigen::Vector3d q = p + t * d;
      bool inside = true;
      for (std::size_t j = 0; j < 3; ++j)
        inside = inside && n.dot((c[(j + 1) % 3] - c[j]).cross(q - c[j])) >= 0.0;
      if (inside)
        first = {t, static_cast<int>(i), k, along > 0.0 ? -n.normalized() : n.normalized()};
    }
  }
  if (!shadow && scene.ground.drawn && p.z() > scene.ground.z && d.z() < 0.0) {
    const double t = (scene.ground.z - p.z()) / d.z();
    if (t < first.t) first = {t, -2, 0, Eigen::Vector3d::UnitZ()};
  }
  return first;
}

}  // namespace armlet::test
