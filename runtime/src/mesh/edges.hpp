// Properties of a surface of triangles that follow from its edges.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// open_because  empty: every edge is as often gone in one direction as in the other.
// is_convex     closed, every edge between two triangles and bent outward, or inward by no more
//               than `rounding`, m, one piece, without holes through it.
// is_one_shell  one piece whose edges belong to two triangles each.
struct EdgeReport {
  std::string open_because;
  bool is_convex = false;
  bool is_one_shell = false;
};

EdgeReport look_at(std::span<const Eigen::Vector3d> vertices, std::span<const Corners> triangles,
                   double rounding);

// The shell that each triangle belongs to, from 0 on. Triangles of one shell are connected by
// edges that belong to two triangles alone; where that leaves a part open, edges of more connect.
struct Shells {
  std::vector<std::uint32_t> of;
  std::size_t count = 0;
};

// Of a closed surface.
Shells shells_of(std::span<const Corners> triangles);

}  // namespace armlet
