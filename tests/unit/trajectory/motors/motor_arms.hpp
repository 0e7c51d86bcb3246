// Random arms with motors, for the tests of motions that motors limit.
#pragma once

#include <vector>

#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "random_mass.hpp"

namespace armlet {

enum class Rub { kNone, kDry, kAll };

// An arm whose motors give somewhat more than what holds it along the path.
inline Robot arm_for(Random& random, const Trajectory& path, Rub rub) {
  RobotSpec spec = random_heavy_arm(random, path.n()).spec();
  for (Link& link : spec.links) {
    link.gear = random.uniform(-60.0, 60.0);
    if (rub != Rub::kNone) link.friction = {.coulomb_plus = 0.01, .coulomb_minus = -0.008};
    if (rub == Rub::kAll) {
      link.friction.viscous = random.uniform(0.0, 1e-3);
      link.friction.static_torque = 0.015;
      link.friction.stribeck_speed = random.uniform(1.0, 5.0);
    }
  }
  const Robot heavy(spec);
  Eigen::VectorXd most = Eigen::VectorXd::Zero(path.n());
  for (int k = 0; k <= 50; ++k) {
    Eigen::VectorXd q(path.n());
    for (int i = 0; i < path.n(); ++i) q[i] = path.value(i, path.duration() * k / 50.0);
    most = most.cwiseMax(gravity_forces(heavy, q).cwiseAbs());
  }
  for (int i = 0; i < path.n(); ++i)
    spec.joints[static_cast<std::size_t>(i)].max_effort = 3.0 + random.uniform(1.3, 4.0) * most[i];
  return Robot(spec);
}

}  // namespace armlet
