// Distances of meshes that are not convex, by their triangles.
#pragma once

#include "armlet/collision/solid.hpp"

namespace armlet {

// Distances, as of gap_between and is_farther, for bodies of which at least one is not convex.
Gap mesh_gap(const Solid& a, const Solid& b);
bool is_mesh_farther(const Solid& a, const Solid& b, double distance);

}  // namespace armlet
