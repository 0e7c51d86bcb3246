#pragma once

#include <string>
#include <vector>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// A joint outside its range.
//
// joint  index from 0.
// value  what it would have to be; limit, the bound that it passes. Both rad or m.
struct LimitViolation {
  int joint = 0;
  double value = 0.0;
  double limit = 0.0;

  double excess() const { return value > limit ? value - limit : limit - value; }
};

// Wherever q is an argument it has n joint values, rad or m, and ArgumentError is thrown if it has
// another number of them.

// Joints of q that lie outside their limits by more than tolerance, in joint order.
std::vector<LimitViolation> limit_violations(const Robot& robot, JointsIn q,
                                             double tolerance = 1e-9);

// Whether no joint lies outside its limits by more than tolerance, rad or m.
bool within_limits(const Robot& robot, JointsIn q, double tolerance = 1e-9);

// q with every joint moved to the nearest value within its limits.
Eigen::VectorXd clamp_to_limits(const Robot& robot, JointsIn q);

// q with every revolute joint moved by whole revolutions to the copy nearest to q_near among those
// within the limits; a joint of which no copy lies within them keeps the copy nearest to its range.
Eigen::VectorXd wrap_near(const Robot& robot, JointsIn q, JointsIn q_near);

// An angle moved by whole revolutions to the copy nearest to `near` among those from lower to
// upper; if none lies there, the copy nearest to that range.
double wrapped_within(double angle, double near, double lower, double upper);

// From each joint to the nearer of its limits, n values, rad or m; below 0 outside.
Eigen::VectorXd limit_margins(const Robot& robot, JointsIn q);

// "joint 2 would turn to 152 deg; its range is -145 deg to 145 deg"
std::string describe(const Robot& robot, const LimitViolation& violation);

}  // namespace armlet
