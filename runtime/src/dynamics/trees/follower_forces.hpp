#pragma once

#include "armlet/model/joint_arrays.hpp"
#include "armlet/model/mechanism.hpp"

// The contribution of links behind mimic joints outside of the chain (RobotSpec::followers) to the
// dynamics of an arm. With the values C q + offset of the joints that carry them, C' maps their
// forces to the joints of the arm. All functions throw ArgumentError for values that are not
// finite.
namespace armlet {

inline bool has_followers(const Robot& robot) { return robot.spec().followers != nullptr; }

// Adds the forces of a motion without friction. Rates and accelerations may be empty: zero.
void add_follower_forces(const Robot& robot, JointsIn q, const Eigen::VectorXd& qd,
                         const Eigen::VectorXd& qdd, bool gravity, JointVector& tau);

void add_follower_friction(const Robot& robot, JointsIn qd, JointVector& tau);

void add_follower_inertia(const Robot& robot, JointsIn q, JointMatrix& M);

// Adds their Coriolis matrix, that of Christoffel: for velocity forces h(qd), which are quadratic,
// column j is (h(qd + e_j) - h(qd) - h(e_j)) / 2.
void add_follower_coriolis(const Robot& robot, JointsIn q, JointsIn qd, JointMatrix& C);

// Adds the derivatives of their forces. The one by q is a central difference of fourth order, exact
// to about 1e-10 of the forces; the one by qd is twice the Coriolis matrix plus the slope of
// friction, without Stribeck friction.
void add_follower_derivatives(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd,
                              JointMatrix& by_q, JointMatrix& by_qd);

double follower_potential_energy(const Robot& robot, JointsIn q);

// The parameters of those links that have some, kLinkParameters each, and the columns of the
// regressor for the joints of the arm.
Eigen::VectorXd follower_parameters(const Robot& robot);
Eigen::MatrixXd follower_regressor(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd);

}  // namespace armlet
