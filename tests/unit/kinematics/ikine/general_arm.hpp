// Arms without any structure, and where they are singular.
#pragma once

#include <Eigen/LU>
#include <optional>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// Joints that neither meet nor are parallel; one of them is a slide if asked for.
inline Robot general_arm(Random& random, bool slides, std::uint64_t n = 6) {
  RobotSpec spec;
  const std::uint64_t slide = slides ? random.below(n) : n;
  for (std::uint64_t i = 0; i < n; ++i) {
    Joint joint;
    joint.dh = {0.0, random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                random.uniform(-1.8, 1.8)};
    if (i == slide) joint.kind = JointKind::kPrismatic;
    joint.lower = i == slide ? -0.5 : -random.uniform(2.0, 5.0);
    joint.upper = i == slide ? 0.5 : random.uniform(2.0, 5.0);
    spec.joints.push_back(joint);
  }
  return Robot(spec);
}

// The value of a joint at which an arm of six joints is singular, if there is one between its
// limits.
inline std::optional<double> singular_value(const Robot& robot, Eigen::VectorXd q, int joint) {
  const auto determinant = [&](double value) {
    q[joint] = value;
    const Jacobian J = jacobian(robot, q);
    return Eigen::Matrix<double, 6, 6>(J).determinant();
  };
  const double lower = robot.lower()[joint], range = robot.upper()[joint] - lower;
  double low = lower, high = low;
  const double at_lower = determinant(low);
  for (int k = 1; k <= 60; ++k) {
    high = lower + range * k / 60.0;
    if (determinant(high) * at_lower < 0.0) break;
    low = high;
  }
  if (determinant(high) * at_lower > 0.0) return std::nullopt;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (determinant(middle) * at_lower < 0.0 ? high : low) = middle;
  }
  return low;
}

}  // namespace armlet
