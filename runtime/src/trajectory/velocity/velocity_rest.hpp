// Deceleration of each joint in its own time, such that the tool exceeds its speeds least.
#pragma once

#include "armlet/trajectory/velocity.hpp"
#include "trajectory/velocity/velocity_motion.hpp"

namespace armlet {

// The fraction by which the tool exceeds the largest speeds between two times of a motion.
double excess_of(const Robot& robot, const Trajectory& motion, double begin, double end,
                 const ToolSpeeds& most);

// The shares of their limits on acceleration and jerk with which the joints come to rest
// independently, and the fraction by which the tool then exceeds the largest speeds; infinite if a
// joint leaves its limits.
struct Rest {
  Eigen::VectorXd shares;
  double excess = 0.0;
};

// The deceleration with the least excess, by coordinate descent: changing the share of a single
// joint does not improve it. Ends early when the excess is allowed.
//
// source  S. J. Wright, Coordinate descent algorithms, Mathematical Programming 151, 2015.
Rest calmest_rest(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most,
                  double calm);

// Ends a motion with such a deceleration.
void come_to_rest_apart(const Robot& robot, VelocityPieces& pieces, const Eigen::VectorXd& shares);

}  // namespace armlet
