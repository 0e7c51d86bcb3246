#pragma once

#include <Eigen/Core>
#include <string_view>

#include "armlet/model/mechanism.hpp"

// Dynamics of trees of links with coupled joints: with joint values C q + offset
//
//   tau = C' (H (C qdd) + c + g + f) = M(q) qdd + ...
//
// where H, c, g and f are the inertia matrix, the velocity forces, gravity and friction of the
// joints as if each had its own motor, and tau are the forces of the actuators, N m and N. Motor
// and friction of a link (Link::gear, motor_inertia, friction) belong to its joint.
//
// q, qd, qdd  one value per actuator, rad or m, and their rates; limits are not checked.
// gravity     acceleration in the axes of the base, m/s^2.
//
// All functions throw ArgumentError unless their arguments have one finite element for each
// actuator and every result is finite.
namespace armlet {

struct MechanismMotion {
  Eigen::VectorXd q{}, qd{}, qdd{};
};

// source  R. Featherstone, Rigid Body Dynamics Algorithms, 2008, table 5.1 (recursive
//         Newton-Euler for trees) and section 3.6 (coupled joints).
Eigen::VectorXd inverse_dynamics(const Mechanism& mechanism, const MechanismMotion& motion,
                                 const Eigen::Vector3d& gravity);

// The actuator forces that hold the mechanism at rest.
Eigen::VectorXd gravity_forces(const Mechanism& mechanism, const Eigen::VectorXd& q,
                               const Eigen::Vector3d& gravity);

// The inertia matrix, symmetric, with the rotors seen at the joints, actuators x actuators.
//
// source  Featherstone 2008, table 6.2: composite rigid bodies.
Eigen::MatrixXd mass_matrix(const Mechanism& mechanism, const Eigen::VectorXd& q);

// The acceleration that actuator forces tau cause.
//
// throws  ArgumentError also if an actuator, which it names, moves no inertia.
Eigen::VectorXd forward_dynamics(const Mechanism& mechanism, const Eigen::VectorXd& q,
                                 const Eigen::VectorXd& qd, const Eigen::VectorXd& tau,
                                 const Eigen::Vector3d& gravity);

// inverse_dynamics(q, qd, qdd) = Y p without Stribeck friction, which is not linear. p has the
// parameters of all bodies in order, kLinkParameters each as in identification.hpp, in their own
// frames; those of motors and friction are zero for fixed bodies. Y is actuators x p.size() and
// depends on the geometry and on gravity alone.
Eigen::VectorXd dynamic_parameters(const Mechanism& mechanism);
Eigen::MatrixXd dynamics_regressor(const Mechanism& mechanism, const MechanismMotion& motion,
                                   const Eigen::Vector3d& gravity);

// The mechanism with a payload that is fixed to a tip; its centre and inertia are in the frame of
// the tip.
//
// throws  ArgumentError if there is no such tip, and for a payload that no body has.
Mechanism with_payload(const Mechanism& mechanism, std::string_view tip, const Payload& payload);

// 1/2 qd' M qd, and minus the sum of mass times gravity times centre of mass, J.
double kinetic_energy(const Mechanism& mechanism, const Eigen::VectorXd& q,
                      const Eigen::VectorXd& qd);
double potential_energy(const Mechanism& mechanism, const Eigen::VectorXd& q,
                        const Eigen::Vector3d& gravity);

}  // namespace armlet
