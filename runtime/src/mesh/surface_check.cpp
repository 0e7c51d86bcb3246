#include "mesh/surface_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

constexpr double kFarthest = 1e4;  // m

void check_vertices(const std::vector<Vector3d>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!vertices[i].allFinite())
      throw ArgumentError(fmt::format("vertex {} has a coordinate that is no number", i));
    if (vertices[i].cwiseAbs().maxCoeff() > kFarthest)
      throw ArgumentError(
          fmt::format("vertex {} is more than 10 km from the origin; lengths are metres", i));
  }
}

void check_triangles(const std::vector<Corners>& triangles, std::size_t vertices) {
  if (triangles.empty()) throw ArgumentError("it has no triangles");
  if (triangles.size() > kMostTriangles) {
    throw ArgumentError(
        fmt::format("it has {} triangles; expected {} at most", triangles.size(), kMostTriangles));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t k : triangles[i]) {
      if (k < vertices) continue;
      throw ArgumentError(
          fmt::format("triangle {} has the corner {}; there are {} vertices", i, k, vertices));
    }
  }
}

}  // namespace

void check_surface(const std::vector<Vector3d>& vertices, const std::vector<Corners>& triangles) {
  check_vertices(vertices);
  check_triangles(triangles, vertices.size());
  const auto has_area = [&](const Corners& c) {
    const Vector3d &p = vertices[c[0]], &q = vertices[c[1]], &r = vertices[c[2]];
    return p != q && q != r && r != p;
  };
  if (std::ranges::none_of(triangles, has_area))
    throw ArgumentError("none of its triangles has three different corners");
}

}  // namespace armlet
