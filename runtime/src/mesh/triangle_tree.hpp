// Construction of a tree of boxes.
#pragma once

#include <span>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// Halves the triangles by the centres of their boxes along the longest side, in the order of their
// numbers if centres coincide, down to kLeaf triangles.
TriangleTree make_tree(std::span<const Eigen::Vector3d> vertices,
                       std::span<const Corners> triangles);

}  // namespace armlet
