// The joint forces of a motion, against what the motors give.
#pragma once

#include <cmath>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The largest force of a joint in a motion.
//
// force  N m or N, with its sign.
// limit  Joint::max_effort; infinite: nobody knows it.
// t      s.
struct PeakForce {
  double force = 0.0;
  double limit = 0.0;
  double t = 0.0;

  [[nodiscard]] double share() const { return std::abs(force) / limit; }
};

struct MotionForces {
  std::vector<PeakForce> peaks;  // one for each joint
  int nearest = -1;              // the joint whose peak has the largest share; -1: none has a limit
  // How many times slower the motion has to be for every joint to keep its limit: 1 if they do, 0
  // if nothing is asked of those that have one. Infinite: a joint cannot even hold the arm and move
  // it slowly somewhere on the way.
  double slower = 0.0;
};

// Whether any joint of the arm has a limit.
[[nodiscard]] bool has_force_limits(const Robot& robot);

// By inverse dynamics at instants at most 5 ms apart, ten thousand at most, in the middle and on
// both sides of every piece of the motion; closer to where most is asked for. A motion that is k
// times slower needs k^2 times less of what is not gravity or friction and k times less against
// viscous friction; with an effect of Stribeck dry friction counts with the worse of standing and
// sliding. Every motion that is slower still keeps the limits too.
//
// throws  ArgumentError unless the motion has one path for each joint, and where forces are beyond
//         the range of numbers.
// source  J. M. Hollerbach, Dynamic scaling of manipulator trajectories, Journal of Dynamic
//         Systems, Measurement, and Control 106, 1984.
MotionForces motion_forces(const Robot& robot, const Trajectory& motion);

// The same of a part of a velocity command, which is given up to a thousand times a second: from
// one time to another, s, at instants at most 5 ms apart and on both sides of the pieces. `slower`
// is worked out only where a joint is beyond its limit.
MotionForces command_forces(const Robot& robot, const Trajectory& motion, double from,
                            double until);

}  // namespace armlet
