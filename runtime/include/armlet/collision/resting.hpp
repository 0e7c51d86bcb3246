// Where bodies of any shape come to rest on each other.
#pragma once

#include <optional>

#include "armlet/world/object.hpp"

namespace armlet {

// z of the frame of `falling` where it rests on `below`, moving only along z: the highest one that
// is no more than kRestTolerance above where it is; nothing if it passes. The shapes count as they
// are, meshes by their triangles; what overlaps another body by less than a micrometre from the
// side passes it. Right to 1e-8 m; the same bits on every machine.
//
// source  conservative advancement along one direction: B. Mirtich, Impulse-based dynamic
//         simulation of rigid body systems, 1996, chapter 2; between convex bodies each step goes
//         to the plane that separates them.
std::optional<double> resting_height_of_shapes(const Object& falling, const Object& below);

}  // namespace armlet
