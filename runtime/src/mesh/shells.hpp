// The closed shells of a surface: the outside of each, and overlaps between them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"
#include "mesh/edges.hpp"

namespace armlet {

// Reverses the shells that are inside out: those whose triangles face inwards and that are in no
// other shell. A shell inside of another one whose triangles face inwards is the surface of a
// cavity and is not changed.
//
// triangles  of a closed surface whose volume is not below 0.
// returns    why its volume counts some regions more than once, as a sentence without a full stop:
//            shells that face outwards inside of others, and shells that intersect. Empty: it does
//            not. At most 24 triangles of each shell are tested, 20,000 in all; with more than
//            5,000 shells nothing is reversed, and the reason says so.
std::string set_shells_right(std::span<const Eigen::Vector3d> vertices,
                             std::vector<Corners>& triangles, const TriangleTree& tree,
                             const Shells& shells);

}  // namespace armlet
