#pragma once

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// From a state in motion to rest, inside of the limits of the joints: as velocity commands end,
// with limited acceleration and jerk, where that is possible. A joint that is too fast for that
// slows down evenly with its largest acceleration, or with the larger one that stops it at its
// limit.
Trajectory way_to_rest(const Robot& robot, const Eigen::VectorXd& q, const Eigen::VectorXd& qd,
                       const Eigen::VectorXd& qdd);

}  // namespace armlet
