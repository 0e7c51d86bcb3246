// Random positions and poses of bodies.
#pragma once

#include <Eigen/Geometry>

#include "armlet/core/random.hpp"

namespace armlet {

inline Eigen::Vector3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Every fourth pose is parallel to the world's axes: faces and edges that lie along each other.
inline Eigen::Isometry3d random_pose(Random& random, double size) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (random.below(4) != 0) {
    const Eigen::Vector3d axis = random_vector(random, 1.0) + Eigen::Vector3d(1e-3, 0.0, 0.0);
    T.linear() = Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis.normalized()).toRotationMatrix();
  }
  T.translation() = random_vector(random, size);
  return T;
}

}  // namespace armlet
