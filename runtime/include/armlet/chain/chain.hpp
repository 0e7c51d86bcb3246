#pragma once

#include <Eigen/Geometry>
#include <array>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

inline constexpr int kMaxJoints = 12;

// A serial arm in m and rad, reduced to the constants of the kinematic recursions, for both
// conventions of Denavit and Hartenberg:
//
//   T_world_tool(q) = T_world_base  prod_i X_i Z_i(q_i)  X_n  T_flange_tool
//   X_i = Rx(alpha_i) Tx(a_i),  Z_i = Rz(theta_i) Tz(d_i)
//
// In the modified convention the last X is the identity; in the standard one, row i gives Z_i and
// X_{i+1}. X_0 .. X_n are stored with the sine and cosine of alpha.
struct Chain {
  int n = 0;
  bool standard = true;
  bool coupled = false;  // some joints are mimic joints, so that the arm has fewer than n values
  std::array<bool, kMaxJoints> revolute{};
  std::array<double, kMaxJoints>
      theta{};                         // offset of a revolute joint, constant of a prismatic one
  std::array<double, kMaxJoints> d{};  // constant of a revolute joint, offset of a prismatic one
  std::array<double, kMaxJoints> q_to_theta{};  // 1 where q adds to theta, else 0
  std::array<double, kMaxJoints> q_to_d{};      // 1 where q adds to d, else 0
  std::array<double, kMaxJoints + 1> a{};
  std::array<double, kMaxJoints + 1> sin_alpha{};
  std::array<double, kMaxJoints + 1> cos_alpha{};
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_flange_tool = Eigen::Isometry3d::Identity();
};

}  // namespace armlet
