#pragma once

#include "armlet/kinematics/jacobian.hpp"

namespace armlet {

// Yoshikawa's measure sqrt(det(J J^T)): of the whole Jacobian for six and more joints, of its
// translational rows for fewer, leaving out directions in which the arm can never move.
//
// q       n joint values, rad or m.
// throws  ArgumentError unless q has n finite elements.
// source  T. Yoshikawa, Manipulability of robotic mechanisms, Int. J. Robotics Research 4(2), 1985.
double manipulability(const Robot& robot, JointsIn q);

// The gradient of the measure, per rad or m of each joint value: with J = U diag(s) V^T, the sum
// over k of u_k^T (dJ/dq_i) v_k times the product of the other singular values. Where a singular
// value is zero the measure has a kink, and the gradient is that of one side.
//
// returns  n values.
// throws   as manipulability().
// source   the derivative u^T dA v of a singular value: G. H. Golub, C. F. Van Loan, Matrix
//          Computations, 4th ed., 2013, chapter 8.
Eigen::VectorXd manipulability_gradient(const Robot& robot, JointsIn q);

// How close the arm is to a singularity.
//
// length      L, which makes radians comparable with metres: robot.length(), m.
// sigma       singular values of diag(1,1,1,L,L,L) J from the largest to the smallest, m; for arms
//             of three and fewer joints only the translational rows count, and directions in which
//             the arm can never move are left out.
// sigma_min   the smallest of them: the distance from the nearest singularity.
// direction   the motion [v; w] that is being lost, a unit vector in world axes (w scaled by L).
// joints      unit vector of the joint motion that moves the tool least.
struct Singularity {
  double length = 0.0;
  Eigen::VectorXd sigma;
  double sigma_min = 0.0;
  Vector6d direction = Vector6d::Zero();
  Eigen::VectorXd joints;
};

// q       n joint values, rad or m.
// throws  ArgumentError unless q has n finite elements.
// source  C. A. Klein, B. E. Blaho, Dexterity measures for the design and control of kinematically
//         redundant manipulators, Int. J. Robotics Research 6(2), 1987: the smallest singular
//         value.
Singularity singularity(const Robot& robot, JointsIn q);

// "cannot move along (0.00, 1.00, 0.00)" or "cannot rotate about (0.00, 0.00, 1.00)"
std::string describe(const Singularity& singularity);

}  // namespace armlet
