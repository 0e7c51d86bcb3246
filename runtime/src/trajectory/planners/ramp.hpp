// Changes of speed with limited acceleration and jerk.
#pragma once

#include <algorithm>
#include <cmath>

#include "armlet/trajectory/profile.hpp"

namespace armlet {

// A change from (v, a) to another speed with no acceleration: a phase of constant jerk, one of
// constant acceleration, and one of jerk with the other sign.
struct Ramp {
  double jerk = 0.0;  // of the first step, with sign
  double rise = 0.0;  // s
  double hold = 0.0;
  double fall = 0.0;

  [[nodiscard]] double duration() const { return rise + hold + fall; }
};

// The shortest ramp, for |a| <= A.
inline Ramp make_ramp(double v, double a, double v_goal, double A, double J) {
  const double need = v_goal - v;
  // Reducing the acceleration directly to zero changes the speed by a |a| / 2 J.
  const double direction = need >= a * std::abs(a) / (2.0 * J) ? 1.0 : -1.0;
  const double x = direction * a;
  const double gain = direction * need;
  double peak = std::sqrt(std::max(J * gain + 0.5 * x * x, 0.0));
  double hold = 0.0;
  if (peak > A) {
    peak = A;
    hold = std::max((gain - (2.0 * A * A - x * x) / (2.0 * J)) / A, 0.0);
  }
  return {
      .jerk = direction * J, .rise = std::max(peak - x, 0.0) / J, .hold = hold, .fall = peak / J};
}

// The state after t seconds of constant jerk.
inline AxisState after(const AxisState& s, double jerk, double t) {
  return {.q = s.q + t * (s.v + t * (0.5 * s.a + t * jerk / 6.0)),
          .v = s.v + t * (s.a + 0.5 * t * jerk),
          .a = s.a + t * jerk};
}

// The state at time t of a ramp that begins in the state s; after its end the speed is constant.
inline AxisState along(const AxisState& s, const Ramp& ramp, double t) {
  const double rise = std::clamp(t, 0.0, ramp.rise);
  const double hold = std::clamp(t - ramp.rise, 0.0, ramp.hold);
  const double fall = std::clamp(t - ramp.rise - ramp.hold, 0.0, ramp.fall);
  const AxisState top = after(after(s, ramp.jerk, rise), 0.0, hold);
  const AxisState end = after(top, -ramp.jerk, fall);
  const double over = t - ramp.duration();
  return over > 0.0 ? after({.q = end.q, .v = end.v, .a = 0.0}, 0.0, over) : end;
}

}  // namespace armlet
