#pragma once

#include <Eigen/Geometry>
#include <array>

#include "armlet/chain/chain.hpp"

namespace armlet {

// The cosine and sine of an angle.
struct Angle {
  double c = 1.0;
  double s = 0.0;
};

inline Angle operator*(const Angle& a, const Angle& b) {
  return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}
inline Angle inverse(const Angle& a) { return {a.c, -a.s}; }

// The form of an arm that the closed forms use:
//
//   G = Z_0 X_1 Z_1 ... X_{n-1} Z_{n-1},   Z_i = Rz(phi_i) Tz(h_i),   X_i = Rx(alpha_i) Tx(a_i)
//
// Parallel axes always point in the same direction (alpha = 0, never pi): phi_i = sign_i (q_i +
// theta_i) for a revolute joint, h_i = sign_i (q_i + d_i) for a prismatic one. The constant poses
// before the first and after the last joint are removed from the goal. Read from the tool to the
// base (G^-1), an arm has this form again.
struct CanonicalRows {
  int n = 0;
  std::array<bool, kMaxJoints> revolute{};
  std::array<double, kMaxJoints> sign{};    // +1 or -1
  std::array<double, kMaxJoints> offset{};  // theta of a revolute joint, d of a prismatic one
  std::array<double, kMaxJoints> h{};       // constant height along z of a revolute joint
  std::array<Angle, kMaxJoints> phi{};      // constant rotation of a prismatic joint
  std::array<double, kMaxJoints>
      a{};  // a[i] and alpha[i] are before joint i; those of 0 are removed
  std::array<Angle, kMaxJoints> alpha{};
  bool reversed = false;  // joint i is joint n-1-i of the arm
  bool flipped = false;   // half a revolution about x remains at the end
  Eigen::Isometry3d before = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d after = Eigen::Isometry3d::Identity();

  Eigen::Vector3d tool_point = Eigen::Vector3d::Zero();  // in the frame of G

  // G of a goal, in the world or in the frame `before`.
  Eigen::Isometry3d goal(const Eigen::Isometry3d& T_world_tool) const {
    return goal_from_base(before * T_world_tool);
  }
  Eigen::Isometry3d goal_from_base(const Eigen::Isometry3d& T_base_tool) const;

  // Whether axes i-1 and i are parallel; whether they meet in a point.
  bool parallel(int i) const { return alpha[static_cast<std::size_t>(i)].s == 0.0; }
  bool meet(int i) const {
    return a[static_cast<std::size_t>(i)] == 0.0 && alpha[static_cast<std::size_t>(i)].s != 0.0;
  }
};

// Rz(x) v.
inline Eigen::Vector3d rotated(const Angle& x, const Eigen::Vector3d& v) {
  return {x.c * v.x() - x.s * v.y(), x.s * v.x() + x.c * v.y(), v.z()};
}

// X_i v for a point v.
inline Eigen::Vector3d placed(const CanonicalRows& rows, std::size_t i, const Eigen::Vector3d& v) {
  const Angle& alpha = rows.alpha[i];
  return {v.x() + rows.a[i], alpha.c * v.y() - alpha.s * v.z(), alpha.s * v.y() + alpha.c * v.z()};
}

CanonicalRows canonical_rows(const Chain& chain, bool reversed);

// X_i of a chain.
Eigen::Isometry3d twist_and_length(const Chain& chain, std::size_t i);

// The arm with its first or its last joint fixed at q.
Chain with_held_joint(const Chain& chain, bool first, double q);

}  // namespace armlet
