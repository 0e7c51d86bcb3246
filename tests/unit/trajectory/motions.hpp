// What the tests of motions of the tool have in common.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "uniform.hpp"

namespace armlet {

// Joint values at time t, n, rad or m.
inline Eigen::VectorXd joints_at(const Trajectory& motion, double t) {
  Eigen::VectorXd q(motion.n());
  for (int i = 0; i < motion.n(); ++i) q[i] = motion.value(i, t);
  return q;
}

// Pose of the tool in the world at time t.
inline Eigen::Isometry3d tool_at(const Robot& robot, const Trajectory& motion, double t) {
  return forward(robot, joints_at(motion, t));
}

// Joint values between home and the middle of the ranges, each moved by at most `most` rad, or by
// `most` times half the range where that is less than 1.
inline Eigen::VectorXd joints_near_home(const Robot& robot, std::mt19937_64& generator,
                                        double most) {
  Eigen::VectorXd q = robot.home();
  for (int i = 0; i < robot.n(); ++i) {
    const double middle = 0.5 * (robot.lower()[i] + robot.upper()[i]);
    const double half = std::min(1.0, robot.upper()[i] - middle);
    q[i] = std::clamp(q[i] + 0.3 * (middle - q[i]) + uniform(generator, -most, most) * half,
                      robot.lower()[i], robot.upper()[i]);
  }
  return q;
}

// The joints stay within their ranges and limits, and accelerations do not jump.
inline void check_limits(const Robot& robot, const Trajectory& motion) {
  for (int i = 0; i < robot.n(); ++i) {
    CHECK(motion.continuity(i, 1e-6) >= 2);
    CHECK(motion.peak(i, 1) <= robot.max_speed()[i] * (1.0 + 1e-8));
    CHECK(motion.peak(i, 2) <= robot.max_accel()[i] * (1.0 + 1e-8));
    CHECK(motion.peak(i, 3) <= robot.max_jerk()[i] * (1.0 + 1e-8));
    CHECK(motion.range(i).upper <= robot.upper()[i] + 1e-9);
    CHECK(motion.range(i).lower >= robot.lower()[i] - 1e-9);
  }
}

}  // namespace armlet
