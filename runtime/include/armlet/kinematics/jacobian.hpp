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
// throws  ArgumentError unless q has n elements.
Jacobian jacobian(const Robot& robot, JointsIn q, JacobianFrame frame = JacobianFrame::kWorld);

// Tool pose and world Jacobian in one pass.
Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J);

// Jdot(q, qd) qd in world axes: the acceleration [a; alpha] of the tool point while qdd = 0.
Vector6d jacobian_dot_qd(const Robot& robot, JointsIn q, JointsIn qd);

// Time derivative of the Jacobian in the same axes while the joints move with qd.
//
// qd      n joint velocities, rad/s or m/s.
// throws  ArgumentError unless q and qd have n finite elements.
Jacobian jacobian_rate(const Robot& robot, JointsIn q, JointsIn qd,
                       JacobianFrame frame = JacobianFrame::kWorld);

}  // namespace armlet
