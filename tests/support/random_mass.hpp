#pragma once

#include "random_arm.hpp"

namespace armlet {

// A rigid body of a few points, so that its inertia is one that bodies have.
inline Link random_link(Random& random) {
  Link link;
  Eigen::Vector3d points[4];
  double masses[4];
  for (int k = 0; k < 4; ++k) {
    masses[k] = random.uniform(0.2, 2.0);
    for (double& x : points[k]) x = random.uniform(-0.3, 0.3);
    link.mass += masses[k];
    link.com += masses[k] * points[k];
  }
  link.com /= link.mass;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d r = points[k] - link.com;
    link.inertia += masses[k] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  if (random.below(2) == 0) {
    link.gear = random.uniform(-80.0, 80.0);
    link.motor_inertia = random.uniform(0.0, 2e-4);
  }
  return link;
}

// An arm of random_arm() with masses and a gravity in any direction.
inline Robot random_heavy_arm(Random& random, int n) {
  RobotSpec spec = random_arm(random, n).spec();
  spec.links.clear();
  for (int i = 0; i < n; ++i) spec.links.push_back(random_link(random));
  for (double& g : spec.gravity) g = random.uniform(-9.81, 9.81);
  return Robot(spec);
}

inline Eigen::VectorXd random_rates(Random& random, int n) {
  Eigen::VectorXd rates(n);
  for (double& rate : rates) rate = random.uniform(-2.0, 2.0);
  return rates;
}

}  // namespace armlet
