#pragma once

#include <vector>

#include "armlet/kinematics/forward.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

using Matrix6Xd = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Poses of all bodies in the base, in their order.
//
// q       one value per actuator, rad or m; limits are not checked.
// throws  ArgumentError unless q has as many elements as there are actuators.
// source  R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 4.
std::vector<Eigen::Isometry3d> body_frames(const Mechanism& mechanism, JointsIn q);

// Pose T_base_tip of a tip; q and exceptions as above.
Eigen::Isometry3d tip_pose(const Mechanism& mechanism, JointsIn q, const Tip& tip);

// Maps actuator speeds to the velocity [v; w] of a tip's origin in the axes of the base: J C, where
// J belongs to the joints and C couples them to the actuators.
//
// returns 6 x actuators.
// throws  as body_frames().
// source  Siciliano et al., Robotics, 2009, section 3.1.3, along the path from the base to the tip.
Matrix6Xd tip_jacobian(const Mechanism& mechanism, JointsIn q, const Tip& tip);

}  // namespace armlet
