#pragma once
// Parts of triangles in front of the camera.

#include <Eigen/Core>
#include <array>

#include "armlet/camera/pinhole.hpp"

namespace armlet::raster {

// Summed in this order, so that the bits are the same on every machine.
inline double dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Corners of a clipped triangle, in order: at most three and one for each plane.
struct Polygon {
  static constexpr int kMost = 8;
  std::array<Eigen::Vector3d, kMost> p{};
  int size = 0;
};

// The points with n . p + d >= 0.
struct HalfSpace {
  Eigen::Vector3d n;
  double d = 0.0;
  [[nodiscard]] double at(const Eigen::Vector3d& p) const { return dot(n, p) + d; }
};
Polygon cut(const Polygon& whole, const HalfSpace& side);

// The part of a triangle of the camera's frame at z >= near whose pixels are within the guard.
// Shared edges of two triangles are cut at the same points, bit by bit.
//
// source  I. E. Sutherland and G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM
//         17(1), 1974.
Polygon clipped(const std::array<Eigen::Vector3d, 3>& triangle, const Intrinsics& camera);

}  // namespace armlet::raster
