#pragma once

#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "armlet/model/dh.hpp"

namespace armlet {

enum class JointKind { kRevolute, kPrismatic };

// Limits at least this wide to both sides, in rad, count as none: 10,000 revolutions.
inline constexpr double kNoLimit = 2.0e4 * std::numbers::pi;
inline constexpr bool is_no_limit(double lower, double upper) {
  // tolerance for limits that were converted from degrees
  constexpr double kRounded = kNoLimit * (1.0 - 1e-12);
  return lower <= -kRounded && upper >= kRounded;
}

// The drive of a row of the joint table: a joint of its own, or (a mimic joint) the joint of
// another row,
//
//   value of the row = ratio q + offset,
//
// with q the value of the joint of row `of`.
//
// of  the row with that joint, from 0; -1: the row has a joint of its own.
struct RowDrive {
  int of = -1;
  double ratio = 1.0;
  double offset = 0.0;
};

// One joint, in rad and rad/s (revolute) or m and m/s (prismatic).
//
// A rate of 0 stands for the default: 180 deg/s or 0.5 m/s; full speed in 0.25 s; full acceleration
// in 0.1 s. Robot replaces it by that number.
struct Joint {
  JointKind kind = JointKind::kRevolute;
  DhRow dh;
  double lower = -2.0 * std::numbers::pi;
  double upper = 2.0 * std::numbers::pi;
  double max_speed = 0.0;
  double max_accel = 0.0;
  double max_jerk = 0.0;
  double max_effort = std::numeric_limits<double>::infinity();  // N m or N
  RowDrive drive{};                                             // of its row

  bool is_revolute() const { return kind == JointKind::kRevolute; }
  // Whether it may rotate without end: a revolute joint without limits.
  bool is_continuous() const { return is_revolute() && is_no_limit(lower, upper); }
};

inline constexpr double kDefaultRevoluteSpeed = std::numbers::pi;  // rad/s
inline constexpr double kDefaultPrismaticSpeed = 0.5;              // m/s
inline constexpr double kDefaultTimeToSpeed = 0.25;                // s
inline constexpr double kDefaultTimeToAccel = 0.1;                 // s

// A joint's value, rad or m, in readable units: "152.4 deg" for a revolute joint, "37.2 mm" for a
// prismatic one.
std::string format_joint_value(JointKind kind, double value);
// A joint's value with as many decimals as distinguish it from another value: "140.03 deg" beside
// "140 deg".
std::string format_joint_value(JointKind kind, double value, double beside);

// "turn" or "slide".
std::string_view joint_word(JointKind kind);

}  // namespace armlet
