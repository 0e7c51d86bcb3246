#pragma once

#include "armlet/core/error.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/model/joint_arrays.hpp"

namespace armlet {

// The joint forces that give the tool an acceleration a in k directions, and leave the other
// directions free: J' Lambda (a - Jdot qd) + h with Lambda = (J M^-1 J')^-1.
//
// M        n x n, the inertia matrix.
// J        k x n, k rows of the Jacobian.
// a        k accelerations minus the part that the speeds alone cause: a - Jdot qd.
// h        n joint forces at these speeds without acceleration.
// damping  rate, 1/s, at which self-motions decay, which these directions do not affect; 0:
//          undamped.
// qd       n joint speeds.
// returns  an error if the k directions are not independent, as at a singular position.
// throws   ArgumentError on mismatched sizes, elements that are not finite, and an M that is not
//          positive definite.
// source   O. Khatib, A unified approach for motion and force control of robot manipulators, IEEE
//          Journal of Robotics and Automation 3(1), 1987.
Result<JointVector> operational_forces(const Eigen::MatrixXd& M, const Eigen::MatrixXd& J,
                                       const Eigen::VectorXd& a, JointsIn h, JointsIn qd,
                                       double damping = 0.0);

// Displacement and velocity of a compliant tool under a force: m a + d v + k x = f in each of six
// directions.
struct Compliance {
  Vector6d offset = Vector6d::Zero();  // x, m and rad
  Vector6d rate = Vector6d::Zero();    // v
};

// The state after h seconds of a constant wrench f; exact.
//
// mass, damping, stiffness  kg and kg m^2, > 0; N s/m and N m s, >= 0; N/m and N m, >= 0.
// throws  ArgumentError for others, and for a result that is not finite.
// source  N. Hogan, Impedance control: an approach to manipulation, Journal of Dynamic Systems,
//         Measurement, and Control 107, 1985; here solved for the motion.
Compliance give_way(const Compliance& from, const Vector6d& wrench, const Vector6d& mass,
                    const Vector6d& damping, const Vector6d& stiffness, double h);

}  // namespace armlet
