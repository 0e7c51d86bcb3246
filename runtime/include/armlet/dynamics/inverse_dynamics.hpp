#pragma once

#include "armlet/math/twist.hpp"
#include "armlet/model/joint_arrays.hpp"

// The joint forces of a motion. Throughout, tau are the forces of the motors, seen at the joints,
// in N m (revolute) and N (prismatic):
//
//   tau = M(q) qdd + C(q, qd) qd + g(q) + f(qd) - J(q)' w
//
// with the inertia of rotors, seen at the joints, in M, friction f and a wrench w that the
// environment exerts on the tool. q, qd and qdd are n joint values, rad or m, and their rates;
// limits are not checked. All functions throw ArgumentError unless their arguments have n finite
// elements and every result is finite.
namespace armlet {

// M(q) qdd + C(q, qd) qd + g(q) + f(qd).
//
// source  J. Y. S. Luh, M. W. Walker, R. P. C. Paul, On-line computational scheme for mechanical
//         manipulators, Journal of Dynamic Systems, Measurement, and Control 102, 1980.
JointVector inverse_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd);

// Inverse dynamics with a wrench [f; m] that the environment exerts on the tool point, in world
// axes, N and N m.
JointVector inverse_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd,
                             const Vector6d& wrench);

// C(q, qd) qd + g(q): inverse dynamics without acceleration and friction.
JointVector bias_forces(const Robot& robot, JointsIn q, JointsIn qd);

// g(q): the joint forces that hold the arm at rest.
JointVector gravity_forces(const Robot& robot, JointsIn q);

// C(q, qd) qd: Coriolis and centrifugal forces.
JointVector coriolis_forces(const Robot& robot, JointsIn q, JointsIn qd);

// f(qd), as Link::friction describes it. Throws ArgumentError also where qd is not finite.
JointVector friction_forces(const Robot& robot, JointsIn qd);

// J(q)' w: the joint forces that balance a wrench [f; m] which the tool exerts on its environment.
JointVector wrench_forces(const Robot& robot, JointsIn q, const Vector6d& wrench);

}  // namespace armlet
