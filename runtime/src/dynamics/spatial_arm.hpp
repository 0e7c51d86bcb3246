#pragma once

#include <array>

#include "armlet/math/twist.hpp"
#include "armlet/model/joint_arrays.hpp"

namespace armlet {

// An arm in one configuration, for spatial vectors: motions [v; w] and forces [f; m] about the
// origin of the base in the world's axes, so that no vector has to be transformed from link to
// link.
//
// source  R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2.
struct SpatialArm {
  // throws  ArgumentError if an element of q is not finite.
  SpatialArm(const Robot& robot, JointsIn q);

  std::array<Vector6d, kMaxJoints> axis;            // the motion of joint i for a rate of 1
  std::array<Matrix6d, kMaxJoints> inertia;         // of link i, with mass on axes regrouped
  std::array<Eigen::Isometry3d, kMaxJoints> frame;  // after Z_i of the WalkPlan, in the world
  Vector6d base_acceleration;                       // minus gravity
};

// The cross product of motions, and of a motion and a force: x* = -(x)'.
Vector6d spatial_cross(const Vector6d& motion, const Vector6d& other);
Vector6d spatial_cross_force(const Vector6d& motion, const Vector6d& force);
Matrix6d spatial_cross_matrix(const Vector6d& motion);

// The inertia of a body with a mass and moments (plan_dynamics.hpp) about the reference point of
// motions.
struct Moments;
Matrix6d spatial_inertia(const Moments& body);

}  // namespace armlet
