#pragma once

#include "armlet/core/error.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/model/joint_arrays.hpp"

namespace armlet {

// The inertia matrix M(q), n x n, symmetric; its diagonal includes the inertia of the rotors, seen
// at the joints; kg m^2, kg m and kg.
//
// throws  ArgumentError unless q has n finite elements.
// source  M. W. Walker, D. E. Orin, Efficient dynamic computer simulation of robotic mechanisms,
//         Journal of Dynamic Systems, Measurement, and Control 104, 1982: composite rigid bodies.
JointMatrix mass_matrix(const Robot& robot, JointsIn q);

// The acceleration that joint forces tau cause: M(q)^-1 (tau - C(q, qd) qd - g(q) - f(qd)), rad/s^2
// and m/s^2.
//
// tau     n joint forces, N m or N.
// throws  ArgumentError unless all have n finite elements and the result is finite, and if M(q) is
//         not positive definite: it names the joint without inertia.
JointVector forward_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn tau);

// Forward dynamics by the articulated-body algorithm, whose cost grows with n and not with its
// cube.
//
// source  R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 7.1.
JointVector articulated_body(const Robot& robot, JointsIn q, JointsIn qd, JointsIn tau);

// The effective inertia at the tool point: (J M^-1 J')^-1, 6 x 6 in the axes of J.
//
// M        n x n, positive definite.
// J        6 x n, from jacobian().
// returns  an error if J has not rank 6, as at a singular position or with fewer than six joints.
// throws   ArgumentError on mismatched sizes and elements that are not finite.
// source   O. Khatib, A unified approach for motion and force control of robot manipulators, 1987.
Result<Matrix6d> operational_inertia(const Eigen::MatrixXd& M, const Eigen::MatrixXd& J);

}  // namespace armlet
