// The joint forces of a motion, compared with the limits of the motors.
#pragma once

#include <cmath>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The largest force of a joint in a motion.
//
// force  N m or N, with its sign.
// limit  Joint::max_effort; infinite: not known.
// t      s.
struct PeakForce {
  double force = 0.0;
  double limit = 0.0;
  double t = 0.0;

  [[nodiscard]] double share() const { return std::abs(force) / limit; }
};

struct MotionForces {
  std::vector<PeakForce> peaks;  // one for each joint
  // the joint with the largest share of its limit; -1: no joint has a limit
  int nearest = -1;
  // How many times slower the motion has to be for every joint to keep its limit: 1 if all do, 0 if
  // joints with a limit need no force. Infinite: somewhere on the path a joint cannot even hold the
  // arm and move it slowly.
  double slower = 0.0;
};

// Whether any joint of the arm has a force limit.
[[nodiscard]] bool has_force_limits(const Robot& robot);

// Inverse dynamics at instants at most 5 ms apart, ten thousand at most, in the middle and on both
// sides of every piece of the motion; closer near the peaks. In a motion that is k times slower,
// forces other than gravity and friction are k^2 times smaller and viscous friction k times; with a
// Stribeck effect dry friction counts with the larger of its values at rest and in motion. Every
// still slower motion keeps the limits too.
//
// throws  ArgumentError unless the motion has one path for each joint, and where forces are beyond
//         the range of numbers.
// source  J. M. Hollerbach, Dynamic scaling of manipulator trajectories, Journal of Dynamic
//         Systems, Measurement, and Control 106, 1984.
MotionForces motion_forces(const Robot& robot, const Trajectory& motion);

// The joint forces of a part of a velocity command, which may be sent up to a thousand times a
// second: from one time to another, s, at instants at most 5 ms apart and on both sides of the
// pieces. `slower` is computed only if a joint is beyond its limit.
MotionForces command_forces(const Robot& robot, const Trajectory& motion, double from,
                            double until);

}  // namespace armlet
