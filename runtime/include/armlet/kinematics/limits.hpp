#pragma once

#include <string>
#include <vector>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// A joint outside its range.
//
// joint  index from 0.
// value  that the goal demands; limit, the bound that it exceeds. Both rad or m.
struct LimitViolation {
  int joint = 0;
  double value = 0.0;
  double limit = 0.0;

  double excess() const { return value > limit ? value - limit : limit - value; }
};

// In all functions below q has n joint values, rad or m; ArgumentError is thrown for another number
// of them.

// Joints of q that lie outside their limits by more than tolerance, in joint order.
std::vector<LimitViolation> limit_violations(const Robot& robot, JointsIn q,
                                             double tolerance = 1e-9);

// Whether no joint lies outside its limits by more than tolerance, rad or m.
bool within_limits(const Robot& robot, JointsIn q, double tolerance = 1e-9);

// q with every joint moved to the nearest value within its limits.
Eigen::VectorXd clamp_to_limits(const Robot& robot, JointsIn q);

// q with every revolute joint moved by whole revolutions to the copy nearest to q_near within the
// limits; if no copy is within them, to the copy nearest to its range.
Eigen::VectorXd wrap_near(const Robot& robot, JointsIn q, JointsIn q_near);

// An angle moved by whole revolutions to the copy nearest to `near` between lower and upper; if
// there is none, to the copy nearest to that range.
double wrapped_within(double angle, double near, double lower, double upper);

// From each joint to the nearer of its limits, n values, rad or m; below 0 outside.
Eigen::VectorXd limit_margins(const Robot& robot, JointsIn q);

// "joint 2 would turn to 152 deg; its range is -145 deg to 145 deg"
std::string describe(const Robot& robot, const LimitViolation& violation);

}  // namespace armlet
