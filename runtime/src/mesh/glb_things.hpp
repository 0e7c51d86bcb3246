#pragma once
// Properties of nodes of a scene as things of a world.

#include <Eigen/Core>
#include <cstdint>
#include <set>
#include <string>

namespace armlet {

// The rotation in a linear map: its axes made perpendicular in their order; the identity if it is
// flat.
Eigen::Matrix3d rotation_in(const Eigen::Matrix3d& linear);

// A name that a program can write between quotes and that is not in `names` yet; it is added to
// them.
std::string unique_name(std::string name, std::uint64_t number, std::set<std::string>& names);

// "#rrggbb" of a linear colour, in the encoding of screens.
//
// source  IEC 61966-2-1 (sRGB), 1999.
std::string shown_color(const double linear[3]);

}  // namespace armlet
