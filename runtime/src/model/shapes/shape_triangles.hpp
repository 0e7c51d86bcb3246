#pragma once
// Shapes of links as triangles.

#include "armlet/mesh/glb.hpp"
#include "armlet/model/link_shapes.hpp"

namespace armlet {

// Adds the closed surface of a shape, in the frame of its link.
void add_triangles(const LinkShape& shape, GlbPart& part);

}  // namespace armlet
