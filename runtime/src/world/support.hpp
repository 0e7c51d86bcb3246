// Where a body that falls straight down comes to rest on another one.
#pragma once

#include <optional>

#include "armlet/world/object.hpp"

namespace armlet {

// Distance of the lowest point of a body below the origin of its frame, m.
double half_height(const Object& object);

// Whether the footprint of a body says all about where others rest on it: spheres, upright
// cylinders, boxes and planes with a vertical axis.
bool has_plain_footprint(const Object& object);

// How far a body, or the box around it that it counts as where it rests, is from its frame at most.
double resting_reach(const Shape& shape);

// The radius of a ball about the origin of its frame that lies inside a body wherever others rest
// on it, m; below zero without end for meshes, which may be hollow there. Where the balls of two
// bodies overlap by more than a tolerance, neither rests on the other within that tolerance.
double resting_core(const Shape& shape);

// z of the centre of `falling` when it rests on `below`, moving only along z; nothing if it passes
// beside it. Exact for boxes with a vertical side, upright and lying cylinders and spheres; a body
// that leans counts as its bounding box, upright in the world's axes, a cone as the cylinder around
// it. Faces in one plane may touch without holding each other.
std::optional<double> resting_height(const Object& falling, const Object& below);

}  // namespace armlet
