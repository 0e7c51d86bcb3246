// Checks whether vertices and triangles form a mesh.
#pragma once

#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// throws  ArgumentError for all that TriangleMesh refuses, in time proportional to their number.
void check_surface(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<Corners>& triangles);

}  // namespace armlet
