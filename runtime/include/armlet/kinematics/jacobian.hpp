#pragma once

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/twist.hpp"

namespace armlet {

// Six rows [v; w] and one column per joint; the storage is inside the object.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints>;

enum class JacobianFrame { kWorld, kBase, kTool };

// Geometric Jacobian of the tool point: [v; w] = J(q) qd.
//
// Column i is [z x (p_tool - p_i); z] for a revolute joint and [z; 0] for a prismatic one, where z
// is the joint's axis and p_i a point on it.
//
// q       n joint values, rad or m.
// frame   the axes in which v and w are expressed; v is always the velocity of the tool point.
// returns 6 x n.
// throws  ArgumentError unless q has n finite elements.
// source  D. E. Whitney, The mathematics of coordinated control of prosthetic arms and
//         manipulators, 1972; Siciliano et al., Robotics, 2009, section 3.1.3.
Jacobian jacobian(const Robot& robot, JointsIn q, JacobianFrame frame = JacobianFrame::kWorld);

// Tool pose in the world and world Jacobian in one pass; q and exceptions as for jacobian().
//
// J  receives 6 x n numbers.
Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J);

// Jdot(q, qd) qd in world axes, m/s^2 and rad/s^2: the acceleration [a; alpha] of the tool point
// while qdd = 0.
//
// q, qd   n joint values, rad or m, and their rates.
// throws  ArgumentError unless both have n finite elements.
// source  J. Y. S. Luh, M. W. Walker, R. P. C. Paul, On-line computational scheme for mechanical
//         manipulators, 1980: the outward recursion of accelerations.
Vector6d jacobian_dot_qd(const Robot& robot, JointsIn q, JointsIn qd);

// Time derivative of the Jacobian in the same axes while the joints move with qd.
//
// qd      n joint velocities, rad/s or m/s.
// throws  ArgumentError unless q and qd have n finite elements.
// source  H. Bruyninckx, J. De Schutter, Symbolic differentiation of the velocity mapping for a
//         serial kinematic chain, Mechanism and Machine Theory 31(2), 1996.
Jacobian jacobian_rate(const Robot& robot, JointsIn q, JointsIn qd,
                       JacobianFrame frame = JacobianFrame::kWorld);

}  // namespace armlet
