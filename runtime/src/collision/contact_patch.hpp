// The feature of a body that is farthest along a direction, and the intersection of two features.
#pragma once

#include <optional>
#include <vector>

#include "armlet/collision/solid.hpp"

namespace armlet {

// A corner, the two ends of an edge, or the corners of a face in order, in the world.
//
// radius  of a round face, about `centre`, m; 0 for all others.
struct ContactPatch {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

ContactPatch contact_patch(const Solid& solid, const Eigen::Vector3d& along);

// The centre of the intersection of both, projected along n, on the first of them; nothing if they
// do not intersect.
std::optional<Eigen::Vector3d> middle_of_both(const ContactPatch& first, const ContactPatch& second,
                                              const Eigen::Vector3d& n);

}  // namespace armlet
