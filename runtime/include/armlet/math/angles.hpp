#pragma once

#include <cmath>
#include <numbers>

namespace armlet {

inline constexpr double kPi = std::numbers::pi;

// Angles are in rad unless the name says deg; no function here throws, and NaN gives NaN.

constexpr double deg_to_rad(double angle_deg) { return angle_deg * (kPi / 180.0); }
constexpr double rad_to_deg(double angle) { return angle * (180.0 / kPi); }

// The angle in (-pi, pi] with the same direction. std::remainder is exact, so the bits are the same
// on every machine.
inline double wrap_angle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

// The smallest rotation from one angle to another, in (-pi, pi].
inline double angle_difference(double to, double from) { return wrap_angle(to - from); }

// The copy of an angle (by whole revolutions) that is nearest to another.
inline double nearest_copy_of_angle(double angle, double near) {
  return near + std::remainder(angle - near, 2.0 * kPi);
}

}  // namespace armlet
