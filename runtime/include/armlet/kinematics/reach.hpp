#pragma once

#include <functional>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// The largest distances of the tool point within the joint limits, m. Robot::reach() is a bound
// that needs no search; these distances are attained.
//
// from_base   distance from the origin of the base.
// from_axis   distance from the axis of the first revolute joint, if it does not move in the base;
//             the same as from_base if the first joint is prismatic.
// q_base, q_axis  joint values with these distances.
struct Reach {
  double from_base = 0.0;
  double from_axis = 0.0;
  Eigen::VectorXd q_base, q_axis;
};

// source  coordinate search over the joints, as maximise_over_joints.
Reach find_reach(const Robot& robot);

// The smallest and the largest world coordinates of the tool point within the joint limits, m. They
// are attained: the box is as small as it can be. Found once for an arm.
//
// source  coordinate search: along a joint, a coordinate is c + a cos q + b sin q or linear.
struct ReachBox {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
};
const ReachBox& reach_box(const Robot& robot);

// The joint values within the limits that maximise a function: one joint after another, from evenly
// spread starts, the same ones in every call.
//
// function  of n joint values within the limits, rad or m.
// starts    number of starts; the first is the home position.
// returns   n joint values; a local maximum, which need not be the global one.
// throws    what the function throws.
// source    J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, chapter 9 (coordinate
//           search).
Eigen::VectorXd maximise_over_joints(const Robot& robot,
                                     const std::function<double(JointsIn)>& function,
                                     int starts = 16);

}  // namespace armlet
