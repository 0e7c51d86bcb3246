#pragma once

#include <Eigen/Geometry>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Twists are [v; w] and wrenches [f; m]: the linear part comes first, in SI units.
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// No function here throws.

// Cross-product matrix: hat(a) b = a x b.
Eigen::Matrix3d hat(const Eigen::Vector3d& a);

// Inverse of hat; the antisymmetric part of W is used.
Eigen::Vector3d vee(const Eigen::Matrix3d& W);

// A twist in other axes: both halves rotated by R_a_b, the reference point unchanged.
Vector6d rotate_twist(const Eigen::Matrix3d& R_a_b, const Vector6d& twist_b);

// Twist of a body at another of its points: v_q = v_p + w x (q - p), in the same axes.
//
// p_q_from_p  vector from the present reference point to the new one, m.
Vector6d move_twist(const Vector6d& twist, const Eigen::Vector3d& p_q_from_p);

// A wrench taken about another point: m_q = m_p - (q - p) x f, in the same axes.
Vector6d move_wrench(const Vector6d& wrench, const Eigen::Vector3d& p_q_from_p);

// Adjoint of a pose: maps a twist at the origin of b in the axes of b to the same motion at the
// origin of a in the axes of a.
Matrix6d adjoint(const Eigen::Isometry3d& T_a_b);

}  // namespace armlet
