// How joints come to rest so that the tool is calm, each in its own time.
#pragma once

#include "armlet/trajectory/velocity.hpp"
#include "trajectory/velocity/velocity_motion.hpp"

namespace armlet {

// By which fraction the tool exceeds the largest speeds between two times of a motion.
double excess_of(const Robot& robot, const Trajectory& motion, double begin, double end,
                 const ToolSpeeds& most);

// By which shares of their limits on acceleration and jerk the joints come to rest, each by itself,
// and by which fraction the tool exceeds the largest speeds then; infinite where a joint leaves its
// limits.
struct Rest {
  Eigen::VectorXd shares;
  double excess = 0.0;
};

// The calmest one, by coordinate descent: no other share of a single joint makes the tool calmer.
// Ends early when it is calm.
//
// source  S. J. Wright, Coordinate descent algorithms, Mathematical Programming 151, 2015.
Rest calmest_rest(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most,
                  double calm);

// Ends a motion so.
void come_to_rest_apart(const Robot& robot, VelocityPieces& pieces, const Eigen::VectorXd& shares);

}  // namespace armlet
