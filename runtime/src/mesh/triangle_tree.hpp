// How a tree of boxes is made.
#pragma once

#include <span>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// Halves the triangles by the middles of their boxes along the longest side, in order of their
// numbers where middles coincide, down to kLeaf triangles.
TriangleTree make_tree(std::span<const Eigen::Vector3d> vertices,
                       std::span<const Corners> triangles);

}  // namespace armlet
