// Bodies of triangles for tests.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet::test {

inline TriangleMesh box_mesh(const Eigen::Vector3d& size,
                             const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d part((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5);
    corners.emplace_back(middle + size.cwiseProduct(part));
  }
  return {std::move(corners),
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}}};
}

// An outline in x and y, counterclockwise, which triangles from its first corner fill, from z = 0
// to `height`.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& outline, double height) {
  const auto n = static_cast<std::uint32_t>(outline.size());
  std::vector<Eigen::Vector3d> corners;
  for (const double z : {0.0, height}) {
    for (const Eigen::Vector2d& p : outline) corners.emplace_back(p.x(), p.y(), z);
  }
  std::vector<Corners> faces;
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    faces.push_back({0, k + 1, k});
    faces.push_back({n, n + k, n + k + 1});
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    faces.push_back({k, next, n + next});
    faces.push_back({k, n + next, n + k});
  }
  return {std::move(corners), std::move(faces)};
}

// The union of a box of 0.1 x 0.02 and one of 0.02 x 0.1, both 0.05 high, with a corner in the
// origin.
inline TriangleMesh angle_iron() {
  return prism({{0.02, 0.02}, {0.02, 0.1}, {0.0, 0.1}, {0.0, 0.0}, {0.1, 0.0}, {0.1, 0.02}}, 0.05);
}

// Bands from pole to pole.
inline TriangleMesh ball_mesh(double radius, int bands) {
  std::vector<Eigen::Vector3d> corners{{0.0, 0.0, -radius}};
  const int n = 2 * bands;
  for (int i = 1; i < bands; ++i) {
    const double t = std::numbers::pi * i / bands;
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / n;
      corners.emplace_back(radius * std::sin(t) * std::cos(angle),
                           radius * std::sin(t) * std::sin(angle), -radius * std::cos(t));
    }
  }
  corners.emplace_back(0.0, 0.0, radius);
  const auto at = [&](int band, int k) {
    if (band == 0) return std::uint32_t{0};
    if (band == bands) return static_cast<std::uint32_t>(corners.size() - 1);
    return static_cast<std::uint32_t>(1 + (band - 1) * n + k % n);
  };
  std::vector<Corners> faces;
  for (int i = 0; i < bands; ++i) {
    for (int k = 0; k < n; ++k) {
      if (i > 0) faces.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
      if (i + 1 < bands) faces.push_back({at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  return {std::move(corners), std::move(faces)};
}

}  // namespace armlet::test
