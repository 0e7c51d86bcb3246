// Overlapping bodies in contact: normal, depth and point of contact.
#pragma once

#include "armlet/collision/solid.hpp"

namespace armlet {

// The normal of the surface where `a` and `b` touch, from b to a, a unit vector. If a face is
// involved it is that of the face, to rounding.
Eigen::Vector3d contact_normal(const Solid& a, const Solid& b);

// Distance by which `a` has to be moved along the unit vector n until it only touches `b`, m; 0 if
// they do not overlap. Exact to 1e-9 m.
double depth_along(const Solid& a, const Solid& b, const Eigen::Vector3d& n);

// Point at which `a`, pressed against `b` along -n, is supported: the centre of the intersection of
// the two lowest features (a face, an edge or a corner of each), on the surface of `a`. Discs count
// as polygons of 64 corners, unless one lies completely in the other face. A feature whose ends
// differ in height by less than 2 micrometres counts as flat.
Eigen::Vector3d pressure_point(const Solid& a, const Solid& b, const Eigen::Vector3d& n);

}  // namespace armlet
