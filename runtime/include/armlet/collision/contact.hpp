// Bodies that are pressed into one another: along which normal, how deep, and where.
#pragma once

#include "armlet/collision/solid.hpp"

namespace armlet {

// The normal of the surface where `a` and `b` touch, from b to a, a unit vector. Where a face
// takes part it is that of the face, to rounding.
Eigen::Vector3d contact_normal(const Solid& a, const Solid& b);

// How far `a` has to be moved along the unit vector n until it only touches `b`, m; 0 if it does
// not overlap it. Right to 1e-9 m.
double depth_along(const Solid& a, const Solid& b, const Eigen::Vector3d& n);

// Where `a`, pressed against `b` along -n, is supported: the middle of what the two lowest
// features, a face, an edge or a corner of each, have in common, on the surface of `a`. Discs count
// as polygons of 64 corners, unless one lies inside the other face as a whole. What is inclined by
// less than 2 micrometres from one end to the other counts as flat.
Eigen::Vector3d pressure_point(const Solid& a, const Solid& b, const Eigen::Vector3d& n);

}  // namespace armlet
