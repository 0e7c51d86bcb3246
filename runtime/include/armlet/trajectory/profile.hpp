// Laws of one axis: cubic, quintic, septic, cycloid and trapezoid, and the least time of each.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Largest magnitudes an axis may reach; infinity where there is no limit.
struct AxisLimits {
  double speed = std::numeric_limits<double>::infinity();         // rad/s or m/s
  double acceleration = std::numeric_limits<double>::infinity();  // rad/s^2 or m/s^2
  double jerk = std::numeric_limits<double>::infinity();          // rad/s^3 or m/s^3
};

// Position, speed and acceleration of one axis.
struct AxisState {
  double q = 0.0;
  double v = 0.0;
  double a = 0.0;
};

enum class LimitKind { kSpeed, kAcceleration, kJerk, kForce };

// The shortest admissible duration, and the limit that determines it.
struct LeastTime {
  double time = 0.0;  // s
  LimitKind limit = LimitKind::kSpeed;
};

// Positions are in rad or m, times in s. Functions that take a duration T throw ArgumentError
// unless T > 0; limits are above zero.

// Cubic with given positions and speeds at both ends; `from.a` and `to.a` are not used.
// T       duration, s, > 0.
// source  Craig, Introduction to Robotics (2005), eq. 7.11.
Segment cubic_segment(const AxisState& from, const AxisState& to, double T);

// Quintic with given position, speed and acceleration at both ends. From rest to rest it is the law
// of least jerk, D (10 x^3 - 15 x^4 + 6 x^5) with x = t / T (Flash and Hogan, 1985).
// T       duration, s, > 0.
// source  Craig, Introduction to Robotics (2005), eq. 7.18.
Segment quintic_segment(const AxisState& from, const AxisState& to, double T);

// Quartic with given position, speed and acceleration at the start, position and speed at the end;
// `to.a` is not used.
// T       duration, s, > 0.
// source  Fu, Gonzalez, Lee, Robotics, 1987, section 4.3.
Segment quartic_segment(const AxisState& from, const AxisState& to, double T);

// From rest to rest with speed, acceleration and jerk zero at both ends:
// D (35 x^4 - 84 x^5 + 70 x^6 - 20 x^7) with x = t / T.
// T       duration, s, > 0.
// source  L. Biagiotti, C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008,
//         section 2.1.
Segment septic_segment(double q0, double q1, double T);

// The cycloid D (x - sin(2 pi x) / 2 pi) with x = t / T as 32 pieces of degree 7 with its position,
// speed, acceleration and jerk at their ends; the error in between is at most 1e-13 D.
// T       duration, s, > 0.
// source  Biagiotti, Melchiorri 2008, section 2.2.
std::vector<Segment> cycloid_segments(double q0, double q1, double T);

// A piece reversed in time: q(T - t), starting at `start`, s.
Segment reversed(const Segment& piece, double start);

// Least time from rest to rest over `travel`, D = |travel|, under limits V, A and J: from the
// largest derivatives of each law over x = t / T.
// source  Biagiotti, Melchiorri 2008, sections 2.1 (polynomials) and 2.2 (cycloid) and chapter 5
//         (scaling in time).
//
// Cubic: max(1.5 D/V, sqrt(6 D/A)); its jerk is unbounded at the ends, so the jerk limit is
// ignored.
LeastTime cubic_least_time(double travel, const AxisLimits& limits);

// Quintic: max(1.875 D/V, sqrt(10/sqrt(3) D/A), cbrt(60 D/J)).
LeastTime quintic_least_time(double travel, const AxisLimits& limits);

// Septic: max(35/16 D/V, sqrt(84 sqrt(5)/25 D/A), cbrt(52.5 D/J)).
LeastTime septic_least_time(double travel, const AxisLimits& limits);

// Cycloid: max(2 D/V, sqrt(2 pi D/A), cbrt(4 pi^2 D/J)).
LeastTime cycloid_least_time(double travel, const AxisLimits& limits);

// Speed rises linearly for `ramp` seconds to `speed`, is constant, and falls linearly for `ramp`
// seconds.
struct Trapezoid {
  double ramp = 0.0;      // s
  double speed = 0.0;     // magnitude of the constant speed
  double duration = 0.0;  // s, >= 2 ramp
};

// The fastest trapezoid (or triangle) over `travel` under speed and acceleration limits.
// Zero travel gives a zero duration.
// source  B. Siciliano et al., Robotics, 2009, section 4.2.1; the three functions below as well.
Trapezoid fastest_trapezoid(double travel, const AxisLimits& limits);
LeastTime trapezoid_least_time(double travel, const AxisLimits& limits);

// The trapezoid of duration T with acceleration A, which has the lowest constant speed; nothing if
// A T^2 < 4 D.
std::optional<Trapezoid> trapezoid_in_time(double travel, double T, double A);

// The trapezoid of duration T that accelerates for `ramp` seconds, 0 < ramp <= T / 2.
Trapezoid trapezoid_with_ramp(double travel, double T, double ramp);

// The pieces of a trapezoid from q over the distance `travel` (with sign).
std::vector<Segment> trapezoid_segments(double q, double travel, const Trapezoid& shape);

}  // namespace armlet
