#pragma once

#include "armlet/model/joint_arrays.hpp"

// All throw ArgumentError unless their arguments have n finite elements.
namespace armlet {

// The matrix C(q, qd) of the Christoffel symbols, n x n: C qd are the Coriolis and centrifugal
// forces, and dM/dt - 2 C is skew-symmetric. Motors rotate about fixed axes and do not contribute.
//
// source  S. Echeandia, P. M. Wensing, Numerical methods to compute the Coriolis matrix and
//         Christoffel symbols for rigid-body systems, Journal of Computational and Nonlinear
//         Dynamics 16(9), 2021.
JointMatrix coriolis_matrix(const Robot& robot, JointsIn q, JointsIn qd);

// The derivatives of inverse_dynamics(): d tau / d q and d tau / d qd, n x n each. d tau / d qdd is
// mass_matrix(). Friction contributes its slope; at qd = 0, where it jumps, only its viscous part.
//
// source  S. Singh, R. P. Russell, P. M. Wensing, Efficient analytical derivatives of rigid-body
//         dynamics using spatial vector algebra, IEEE Robotics and Automation Letters 7(2), 2022.
struct ForceDerivatives {
  JointMatrix by_q, by_qd;
};
ForceDerivatives inverse_dynamics_derivatives(const Robot& robot, JointsIn q, JointsIn qd,
                                              JointsIn qdd);

}  // namespace armlet
