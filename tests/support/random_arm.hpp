#pragma once

#include <bit>
#include <cstdint>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/robot.hpp"

// Arms of every structure: twists that need no arithmetic and others, lengths that are zero and
// others, revolute and prismatic joints, both conventions, with and without a base and a tool.
namespace armlet {

inline double random_twist(Random& random) {
  constexpr double kRightAngle = 1.5707963267948966;
  if (random.below(4) == 0) return random.uniform(-3.0, 3.0);
  return kRightAngle * (static_cast<double>(random.below(4)) - 1.0);
}

inline double random_length(Random& random) {
  return random.below(2) == 0 ? 0.0 : random.uniform(-0.6, 0.6);
}

inline Eigen::Isometry3d random_placement(Random& random) {
  switch (random.below(3)) {
    case 0:
      return Eigen::Isometry3d::Identity();
    case 1:
      return make_translation({random_length(random), random_length(random), 0.2});
    default:
      return pose_from_rpy({0.1, random_length(random), random.uniform(-1.0, 1.0)},
                           {random.uniform(-3.0, 3.0), random.uniform(-1.0, 1.0), 0.4});
  }
}

inline Robot random_arm(Random& random, int n) {
  RobotSpec spec;
  spec.convention = random.below(2) == 0 ? DhConvention::kStandard : DhConvention::kModified;
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.kind = random.below(4) == 0 ? JointKind::kPrismatic : JointKind::kRevolute;
    joint.dh = {random_length(random), random_length(random), random_length(random),
                random_twist(random)};
    spec.joints.push_back(joint);
  }
  spec.T_world_base = random_placement(random);
  spec.T_flange_tool = random_placement(random);
  return Robot(spec);
}

inline Eigen::VectorXd random_values(Random& random, int n) {
  Eigen::VectorXd q(n);
  for (double& value : q) value = random.uniform(-4.0, 4.0);
  return q;
}

// The same numbers, 0 and -0 apart.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Joint values within the limits of an arm.
inline Eigen::VectorXd random_joints(const Robot& robot, Random& random) {
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
  return q;
}

}  // namespace armlet
