// Intersections of the surfaces of two closed shells.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

inline constexpr std::uint32_t kNoShell = std::numeric_limits<std::uint32_t>::max();

// A point at which an edge of one shell intersects a triangle of another one, farther than
// `rounding` (m) from the ends of the edge and the edges of the triangle. At most 20 million pairs
// of boxes and triangles are tested.
//
// shell_of  the shell of each triangle; kNoShell: it is ignored.
std::optional<Eigen::Vector3d> find_crossing(std::span<const Eigen::Vector3d> vertices,
                                             std::span<const Corners> triangles,
                                             const TriangleTree& tree,
                                             std::span<const std::uint32_t> shell_of,
                                             double rounding);

}  // namespace armlet
