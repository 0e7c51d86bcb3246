#pragma once

#include <vector>

#include "armlet/model/joint_arrays.hpp"

// The dynamics of an arm are linear in its masses, moments and friction, so these can be identified
// from measured motions and joint forces. Without Stribeck friction, which is not linear,
//
//   inverse_dynamics(q, qd, qdd) = Y(q, qd, qdd) p.
namespace armlet {

// The parameters of link i are the elements of p from 14 i on:
//
//   m, m cx, m cy, m cz           mass, kg, and first moment, kg m
//   Ixx, Ixy, Ixz, Iyy, Iyz, Izz  inertia about the origin, kg m^2
//   G^2 J                         of the rotor, at the joint, kg m^2
//   G^2 B, |G| Tc+, |G| Tc-       viscous and Coulomb friction, at the joint
//
// the first ten in the link's DH frame. After those of the links come, in the same order, those of
// each link with a mass or friction behind a mimic joint of the arm (RobotSpec::followers), in its
// own frame and at its own joint: 14 (n + followers) in all.
inline constexpr int kLinkParameters = 14;

// p, 14 values for each link. A payload is part of the last link.
Eigen::VectorXd dynamic_parameters(const Robot& robot);

// Y, n x p.size(). It depends on the geometry and on gravity alone. The columns of Tc+ and Tc- are
// 1 while the joint moves in their direction, otherwise 0.
//
// throws  ArgumentError unless the arguments have n finite elements and the result is finite.
// source  C. G. Atkeson, C. H. An, J. M. Hollerbach, Estimation of inertial parameters of
//         manipulator loads and links, International Journal of Robotics Research 5(3), 1986.
Eigen::MatrixXd dynamics_regressor(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd);

// The base parameters, which joint forces can determine: the smallest number of combinations of
// parameters that give all joint forces,
//
//   Y p = Y_b (grouping p),  Y_b the columns `columns` of Y.
//
// columns   linearly independent columns of Y: each that is not a combination of those before it.
// grouping  columns.size() x p.size(): 1 at the parameter of its column, and the factors of the
//           other parameters.
struct BaseParameters {
  std::vector<int> columns;
  Eigen::MatrixXd grouping;
};

// Computed from the rank of Y over seeded random motions, so it is the same in each call.
//
// throws  ArgumentError if the geometry is so large or small that the rank cannot be determined.
// source  M. Gautier, Numerical calculation of the base inertial parameters of robots, Journal of
//         Robotic Systems 8(4), 1991.
BaseParameters base_parameters(const Robot& robot);

}  // namespace armlet
