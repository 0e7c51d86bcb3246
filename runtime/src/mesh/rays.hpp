// Rays through the triangles of a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet::rays {

// Directions that edges of a model are unlikely to have.
inline const std::array<Eigen::Vector3d, 5> kDirections = {
    Eigen::Vector3d(0.531, 0.273, 0.802), Eigen::Vector3d(-0.613, 0.377, -0.694),
    Eigen::Vector3d(0.217, -0.859, 0.464), Eigen::Vector3d(-0.397, -0.661, 0.637),
    Eigen::Vector3d(0.871, 0.413, -0.266)};

// Whether a ray from p along d crosses a triangle: 1 from inside to outside, -1 from outside to
// inside, 0 not at all; `doubt` if it passes too closely to an edge to decide.
int crossing(const Eigen::Vector3d& p, const Eigen::Vector3d& d, const Eigen::Vector3d& a,
             const Eigen::Vector3d& b, const Eigen::Vector3d& c, bool& doubt);
bool meets(const TriangleTree::Node& node, const Eigen::Vector3d& p, const Eigen::Vector3d& d);

// Calls visit(triangle, crossing) for all triangles that a ray crosses.
//
// returns  whether a crossing was doubtful.
template <class Visit>
bool cast(std::span<const Eigen::Vector3d> vertices, std::span<const Corners> triangles,
          const TriangleTree& tree, const Eigen::Vector3d& p, const Eigen::Vector3d& d,
          Visit&& visit) {
  bool doubt = false;
  std::array<std::uint32_t, 64> open{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t at = open[--count];
    const TriangleTree::Node& node = tree.nodes[at];
    if (!meets(node, p, d)) continue;
    if (node.second != 0) {
      open[count++] = node.second;
      open[count++] = at + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Corners& c = triangles[tree.order[i]];
      const int way = crossing(p, d, vertices[c[0]], vertices[c[1]], vertices[c[2]], doubt);
      if (way != 0) visit(tree.order[i], way);
    }
  }
  return doubt;
}

}  // namespace armlet::rays
