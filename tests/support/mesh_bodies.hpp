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

// A box without its inside: walls of 2 mm, each face of n x n squares.
inline TriangleMesh hollow_box(double size, int n) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Corners> triangles;
  const auto shell = [&](double half, bool inward) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const auto at = [&](int i, int k) {
          Eigen::Vector3d p;
          p[axis] = side * half;
          p[(axis + 1) % 3] = half * (2.0 * i / n - 1.0);
          p[(axis + 2) % 3] = half * (2.0 * k / n - 1.0);
          vertices.push_back(p);
          return static_cast<std::uint32_t>(vertices.size() - 1);
        };
        for (int i = 0; i < n; ++i) {
          for (int k = 0; k < n; ++k) {
            const std::uint32_t a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1),
                                d = at(i, k + 1);
            const bool turn = (side < 0.0) != inward;
            triangles.push_back(turn ? Corners{a, c, b} : Corners{a, b, c});
            triangles.push_back(turn ? Corners{a, d, c} : Corners{a, c, d});
          }
        }
      }
    }
  };
  shell(0.5 * size, false);
  shell(0.5 * size - 0.002, true);
  return {std::move(vertices), std::move(triangles)};
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
