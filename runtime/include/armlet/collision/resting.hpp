// Heights at which bodies of any shape come to rest on each other.
#pragma once

#include <optional>

#include "armlet/world/object.hpp"

namespace armlet {

// z of the frame of `falling` at which it rests on `below`, moving only along z: the highest one
// that is at most kRestTolerance above its present z; nothing if it passes. Shapes are exact,
// meshes by their triangles; a body that overlaps another one sideways by less than a micrometre
// passes it. Exact to 1e-8 m; the same bits on every machine.
//
// source  conservative advancement along one direction: B. Mirtich, Impulse-based dynamic
//         simulation of rigid body systems, 1996, chapter 2; between convex bodies each step goes
//         to the plane that separates them.
std::optional<double> resting_height_of_shapes(const Object& falling, const Object& below);

}  // namespace armlet
