// The closed shells of a surface: which side of each is outside, and which of them overlap.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"
#include "mesh/edges.hpp"

namespace armlet {

// Turns the shells that are inside out: those that look inwards and lie in no other one. A shell
// that looks inwards inside of another one is the surface of a cavity and stays.
//
// triangles  of a closed surface whose volume is not below 0.
// returns    why its volume counts some parts of it more than once, as a sentence without an end:
//            shells that look outwards inside of others, and shells that cross. Empty: it does not.
//            24 triangles of each shell at most are looked at, 20,000 together; nothing is turned
//            and the reason says so where there are more than 5,000 shells.
std::string set_shells_right(std::span<const Eigen::Vector3d> vertices,
                             std::vector<Corners>& triangles, const TriangleTree& tree,
                             const Shells& shells);

}  // namespace armlet
