#pragma once

#include <vector>

#include "armlet/model/joint_arrays.hpp"

// The dynamics of an arm are linear in its masses, moments and friction, so these can be found from
// motions and the forces that they took. Without Stribeck's part, which is not linear,
//
//   inverse_dynamics(q, qd, qdd) = Y(q, qd, qdd) p.
namespace armlet {

// The parameters of link i stand in p from 14 i on:
//
//   m, m cx, m cy, m cz           mass, kg, and first moment, kg m
//   Ixx, Ixy, Ixz, Iyy, Iyz, Izz  inertia about the origin, kg m^2
//   G^2 J                         of the rotor, at the joint, kg m^2
//   G^2 B, |G| Tc+, |G| Tc-       viscous and Coulomb friction, at the joint
//
// the first ten in the link's DH frame. Behind those of the links stand, in the same order, those
// of each link with a mass or friction whose joint copies joints of the arm (RobotSpec::followers),
// in its own frame and at its own joint: 14 (n + followers) in all.
inline constexpr int kLinkParameters = 14;

// p, 14 values for each link. A payload counts to the last link.
Eigen::VectorXd dynamic_parameters(const Robot& robot);

// Y, n x p.size(). It depends on the geometry and on gravity alone. The columns of Tc+ and Tc- are
// 1 while the joint moves in their direction, otherwise 0.
//
// throws  ArgumentError unless the arguments have n finite elements and the result is finite.
// source  C. G. Atkeson, C. H. An, J. M. Hollerbach, Estimation of inertial parameters of
//         manipulator loads and links, International Journal of Robotics Research 5(3), 1986.
Eigen::MatrixXd dynamics_regressor(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd);

// What can be told from joint forces: the fewest combinations of parameters that give them all,
//
//   Y p = Y_b (grouping p),  Y_b the columns `columns` of Y.
//
// columns   of Y that do not depend on each other: each that is no combination of those before it.
// grouping  columns.size() x p.size(): 1 at the parameter of its column, and what others add to it.
struct BaseParameters {
  std::vector<int> columns;
  Eigen::MatrixXd grouping;
};

// Found by the rank of Y over seeded random motions, so it is the same at each call.
//
// throws  ArgumentError if the geometry is so large or small that no rank can be told.
// source  M. Gautier, Numerical calculation of the base inertial parameters of robots, Journal of
//         Robotic Systems 8(4), 1991.
BaseParameters base_parameters(const Robot& robot);

}  // namespace armlet
