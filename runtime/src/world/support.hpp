// Heights at which a body that falls straight down comes to rest on another one.
#pragma once

#include <optional>

#include "armlet/world/object.hpp"

namespace armlet {

// Distance of the lowest point of a body below the origin of its frame, m.
double half_height(const Object& object);

// Whether the footprint of a body determines where others rest on it: spheres, upright cylinders,
// boxes and planes with a vertical axis.
bool has_plain_footprint(const Object& object);

// Largest distance of a body, or of the bounding box that replaces it for resting, from its frame.
double resting_reach(const Shape& shape);

// The radius of a ball about the origin of its frame that lies inside a body in every pose in which
// others rest on it, m; minus infinity for meshes, which may be hollow there. If the balls of two
// bodies overlap by more than a tolerance, neither rests on the other within that tolerance.
double resting_core(const Shape& shape);

// z of the centre of `falling` when it rests on `below`, moving only along z; nothing if it passes.
// Exact for boxes with a vertical side, upright and lying cylinders and spheres; a tilted body
// counts as its bounding box along the world's axes, a cone as its bounding cylinder. Faces in one
// plane may touch without carrying each other.
std::optional<double> resting_height(const Object& falling, const Object& below);

}  // namespace armlet
