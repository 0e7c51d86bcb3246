// What the edges of triangles tell of the surface that they make.
#pragma once

#include <span>
#include <string>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// open_because  empty: every edge is as often gone in one direction as in the other.
// is_convex     closed, every edge between two triangles and bent outward, or inward by no more
//               than `rounding`, m, one piece, without holes through it.
struct EdgeReport {
  std::string open_because;
  bool is_convex = false;
};

EdgeReport look_at(std::span<const Eigen::Vector3d> vertices, std::span<const Corners> triangles,
                   double rounding);

}  // namespace armlet
