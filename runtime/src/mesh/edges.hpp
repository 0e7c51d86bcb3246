// Properties of a surface of triangles that follow from its edges.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// open_because  empty: every edge is used as often in one direction as in the other.
// is_convex     closed; every edge between two triangles and convex, or concave by no more than
//               `rounding`, m; one piece without holes through it.
// is_one_shell  one piece whose edges belong to two triangles each.
struct EdgeReport {
  std::string open_because;
  bool is_convex = false;
  bool is_one_shell = false;
};

EdgeReport look_at(std::span<const Eigen::Vector3d> vertices, std::span<const Corners> triangles,
                   double rounding);

// The shell of each triangle, from 0. Triangles of one shell are connected by edges that belong to
// exactly two triangles; if that leaves a part open, also by edges of more.
struct Shells {
  std::vector<std::uint32_t> of;
  std::size_t count = 0;
};

// The connected shells of a closed surface.
Shells shells_of(std::span<const Corners> triangles);

}  // namespace armlet
