#pragma once

#include <Eigen/Core>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// Measures of a good posture, for choosing between solutions for the same pose.
//
// kMidRange        joints in the middle of their ranges.
// kManipulability  far from singularities.
// kNearGiven       near to given joint values, each counted by its range.
enum class Posture { kMidRange, kManipulability, kNearGiven };

// A posture as a goal; q_given, n values, is used by kNearGiven.
struct PostureGoal {
  PostureGoal(Posture which) : posture(which) {}  // NOLINT: a posture alone is a goal
  PostureGoal(Posture which, Eigen::VectorXd q) : posture(which), q_given(std::move(q)) {}

  Posture posture;
  Eigen::VectorXd q_given;
};

// The value of a posture, larger is better: -1/(2n) sum ((q - q_0) / range)^2, with q_0 the middle
// of the range or the given values, or Yoshikawa's measure; and its gradient.
//
// q        n joint values, rad or m.
// returns  the value; the gradient has n elements, per rad or m.
// throws   ArgumentError unless q has n elements, and q_given if it belongs to the posture.
// source   A. Liegeois, Automatic supervisory control of the configuration and behavior of
//          multibody mechanisms, IEEE Trans. SMC 7(12), 1977.
double posture_value(const Robot& robot, JointsIn q, const PostureGoal& goal);
Eigen::VectorXd posture_gradient(const Robot& robot, JointsIn q, const PostureGoal& goal);

}  // namespace armlet
