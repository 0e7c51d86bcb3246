#pragma once
// A camera without distortion at a pose, and linear functions in its picture.

#include <Eigen/Geometry>

#include "armlet/camera/pinhole.hpp"

namespace armlet::raster {

// The function a u + b v + c of pixel (u, v).
struct Linear {
  double a = 0.0, b = 0.0, c = 0.0;
  [[nodiscard]] double at(double u, double v) const { return a * u + (b * v + c); }
};

struct View {
  Intrinsics camera;
  Eigen::Isometry3d T_eye_world;
  Eigen::Isometry3d T_world_eye;

  View(const Intrinsics& intrinsics, const Eigen::Isometry3d& T_world)
      : camera(intrinsics), T_eye_world(T_world.inverse(Eigen::Isometry)), T_world_eye(T_world) {}

  // The function g . (x, y, 1), with the ray (x, y, 1) of pixel (u, v).
  [[nodiscard]] Linear along_ray(const Eigen::Vector3d& g) const {
    const double a = g.x() / camera.fx, b = g.y() / camera.fy;
    return {a, b, g.z() - a * camera.cx - b * camera.cy};
  }
  // 1/z of a plane n . p = d of the camera's frame.
  [[nodiscard]] Linear plane(const Eigen::Vector3d& n, double d) const { return along_ray(n / d); }
};

}  // namespace armlet::raster
