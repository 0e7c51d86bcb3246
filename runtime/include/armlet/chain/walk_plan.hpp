#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "armlet/chain/chain.hpp"

namespace armlet {

// Link twists by the arithmetic that they need: none, an exchange of axes, or a rotation.
enum class LinkTwist : std::uint8_t { kNone, kRightAngle, kAny };

// A chain prepared for the outward recursion over its frames. With B = T_world_base X_0 and T = X_n
// T_flange_tool,
//
//   T_world_tool(q) = B Z_0 X_1 Z_1 ... X_{n-1} Z_{n-1} T,
//
// Where the twist of an X is negative or half a revolution, all later frames are rotated by half a
// revolution about x, which makes the twist positive or zero. Only signs change, so this causes no
// rounding.
struct WalkPlan {
  int n = 0;
  bool standard = true;       // frames after X_{i+1}, else after Z_i
  bool base_is_none = false;  // B is the identity
  bool tool_is_flip = false;  // T is no rotation, or half a revolution about x
  bool tool_on_axis = false;  // and its origin is on the axis of the last joint

  // Z_i = Rz(theta_i + q_to_theta_i q_i) Tz(d_i + q_to_d_i q_i); both factors are 0, 1 or -1.
  std::array<double, kMaxJoints> theta{}, q_to_theta{}, d{}, q_to_d{};
  std::array<bool, kMaxJoints> has_d{};  // d is not zero, or the joint is prismatic

  // X_i = Rx(alpha_i) Tx(a_i) before joint i > 0, and the unchanged X_n for i = n.
  std::array<double, kMaxJoints + 1> a{}, sin_alpha{}, cos_alpha{};
  std::array<bool, kMaxJoints + 1> has_a{};
  std::array<LinkTwist, kMaxJoints + 1> twist{};
  bool right_angle(std::size_t i) const { return twist[i] == LinkTwist::kRightAngle; }
  bool any_angle(std::size_t i) const { return twist[i] == LinkTwist::kAny; }

  // 1, or -1 where the frames at joint i are rotated by half a revolution: their y and z axes are
  // those of the chain times this.
  std::array<double, kMaxJoints> flip{};

  std::array<double, 12> base{};  // B by columns: axes x, y, z, then the origin
  std::array<double, 12> tool{};  // T by rows: parts of x, y, z and the origin
};

// The plan of a chain of 1 to kMaxJoints joints. Throws nothing.
WalkPlan plan_walk(const Chain& chain);

}  // namespace armlet
