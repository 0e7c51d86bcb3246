#pragma once

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A deceleration from a state to rest, inside of the joint limits: like the end of a velocity
// command, with limited acceleration and jerk, if that is possible. A joint that is too fast for
// that has a constant deceleration: its largest one, or the larger one with which it stops at its
// limit.
Trajectory way_to_rest(const Robot& robot, const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                       const Eigen::VectorXd& qdd);

}  // namespace armlet
