#pragma once
// Shapes of links as triangles.

#include "armlet/mesh/glb.hpp"
#include "armlet/model/link_shapes.hpp"

namespace armlet {

// Adds the closed surface of a shape, in the frame of its link.
void add_triangles(const LinkShape& shape, GlbPart& part);

// The same for a mesh, every triangle flat.
void add_triangles(const TriangleMesh& mesh, const Eigen::Isometry3d& T_link_mesh, GlbPart& part);

}  // namespace armlet
