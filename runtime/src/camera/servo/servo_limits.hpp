#pragma once
// Joint speeds of a servo within the limits of the joints.

#include <Eigen/Core>
#include <optional>

#include "armlet/camera/visual_servo.hpp"

namespace armlet {

// A joint whose limit slows the arm down.
//
// room   distance from that limit, rad or m.
// asked  the speed that the law demands of it.
struct JointAtLimit {
  Eigen::Index joint = 0;
  double limit = 0.0;
  double room = 0.0;
  double asked = 0.0;
};

// Speeds within the limits: the demanded ones times `scale`.
//
// rank  of the matrix of the task.
struct LimitedSpeeds {
  Eigen::VectorXd qd;
  double scale = 1.0;
  std::optional<JointAtLimit> at{};
};

// -gain A^+ error, with a self-motion away from the joint limits where A leaves one free. A joint
// that could not stop before its limit is held if the others can do the task without it; otherwise
// all joints are slowed down.
//
// q, period  of ServoSight and ServoOptions.
LimitedSpeeds limited_speeds(const Eigen::MatrixXd& A, const Eigen::VectorXd& error, double gain,
                             const ServoArm& arm, const Eigen::VectorXd& q, double period);

// "12.5 deg", "40 mm" of a joint, and the same per second.
[[nodiscard]] std::string joint_text(const ServoArm& arm, Eigen::Index joint, double value);

}  // namespace armlet
