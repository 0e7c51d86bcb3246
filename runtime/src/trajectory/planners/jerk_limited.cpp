#include "armlet/trajectory/jerk_limited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "armlet/core/error.hpp"
#include "trajectory/bracket.hpp"
#include "trajectory/cube_root.hpp"
#include "trajectory/planners/ramp.hpp"

namespace armlet {
namespace {

constexpr double kShortestStep = 1e-14;  // s; shorter steps have no visible effect
// Rounding of a position, rad or m, over a travel of this size.
double rounding(double travel) { return 1e-15 + 4e-16 * std::abs(travel); }

// The position at which the ramp ends with the speed v_goal. The last step is computed backwards
// from its end.
double end_of_ramp(const AxisState& s, const Ramp& ramp, double v_goal) {
  const AxisState top = after(after(s, ramp.jerk, ramp.rise), 0.0, ramp.hold);
  return top.q + ramp.fall * (v_goal - ramp.jerk * ramp.fall * ramp.fall / 6.0);
}

// The position of the axis after the shortest stop.
double stop_position(const AxisState& s, double A, double J) {
  return end_of_ramp(s, make_ramp(s.v, s.a, 0.0, A, J), 0.0);
}

void add_ramp(JerkProfile& profile, const Ramp& ramp, double sign) {
  profile.add(ramp.rise, sign * ramp.jerk);
  profile.add(ramp.hold, 0.0);
  profile.add(ramp.fall, -sign * ramp.jerk);
}

// A motion from rest to rest: closed forms for the three cases of limits that are reached.
JerkProfile rest_to_rest(double travel, const AxisLimits& limits, double V) {
  const double D = std::abs(travel);
  const double A = limits.acceleration, J = limits.jerk;
  const double up = V * J >= A * A ? A / J + V / A : 2.0 * std::sqrt(V / J);
  double tj = std::min(std::sqrt(V / J), A / J);
  double ta = up;  // s, to the highest speed
  double cruise = 0.0;
  if (D >= V * up) {
    cruise = D / V - up;
  } else if (D >= 2.0 * A * A * A / (J * J)) {
    tj = A / J;
    ta = 0.5 * tj + std::sqrt(0.25 * tj * tj + D / A);
  } else {
    tj = cube_root(D / (2.0 * J));
    ta = 2.0 * tj;
  }
  const double jerk = std::copysign(J, travel);
  const Ramp ramp{.jerk = jerk, .rise = tj, .hold = ta - 2.0 * tj, .fall = tj};
  JerkProfile profile;
  add_ramp(profile, ramp, 1.0);
  profile.add(cruise, 0.0);
  add_ramp(profile, ramp, -1.0);
  profile.set_peak_speed(jerk * tj * (ta - tj));
  return profile;
}

// A motion that accelerates to the speed V, is interrupted in phase `phase` at time t, and then
// stops.
struct BreakOff {
  int phase = 0;
  double t = 0.0;
};

// Appends the steps of the ramp up to the interruption, then the stop.
void add_broken_ramp(JerkProfile& profile, const AxisState& s, const Ramp& ramp, BreakOff moment,
                     double sign, const AxisLimits& limits) {
  const double jerks[3] = {ramp.jerk, 0.0, -ramp.jerk};
  const double lengths[3] = {ramp.rise, ramp.hold, ramp.fall};
  AxisState state = s;
  for (int k = 0; k <= moment.phase; ++k) {
    const double t = k < moment.phase ? lengths[k] : moment.t;
    profile.add(t, sign * jerks[k]);
    state = after(state, jerks[k], t);
  }
  const Ramp stop = make_ramp(state.v, state.a, 0.0, limits.acceleration, limits.jerk);
  add_ramp(profile, stop, sign);
  const double turning = state.v + state.a * std::abs(state.a) / (2.0 * limits.jerk);
  profile.set_peak_speed(state.a >= 0.0 ? sign * std::max(turning, 0.0) : 0.0);
}

// Reduces an acceleration above its limit to the limit, and returns the state after that.
AxisState tame(const AxisState& from, const AxisLimits& limits, JerkProfile& profile) {
  const double excess = std::abs(from.a) - limits.acceleration;
  if (excess <= 0.0) return from;
  const double jerk = -std::copysign(limits.jerk, from.a);
  const double t = excess / limits.jerk;
  profile.add(t, jerk);
  AxisState state = after(from, jerk, t);
  state.a = std::copysign(limits.acceleration, from.a);
  return state;
}

AxisState mirrored(const AxisState& s, double to, double sign) {
  return {.q = sign * (s.q - to), .v = sign * s.v, .a = sign * s.a};
}

JerkProfile from_motion(const AxisState& from, double to, const AxisLimits& limits) {
  const double V = limits.speed, A = limits.acceleration, J = limits.jerk;
  JerkProfile profile;
  const AxisState tamed = tame(from, limits, profile);
  const double sign = stop_position(tamed, A, J) <= to ? 1.0 : -1.0;
  // The target is moved to 0, at or beyond the position after the shortest stop: the axis moves
  // towards it with the speed V.
  const AxisState s = mirrored(tamed, to, sign);
  const Ramp ramp = make_ramp(s.v, s.a, V, A, J);
  const double top = end_of_ramp(s, ramp, V);
  const double past = stop_position({.q = top, .v = V, .a = 0.0}, A, J);
  if (past <= 0.0) {
    add_ramp(profile, ramp, sign);
    profile.add(-past / V, 0.0);
    add_ramp(profile, make_ramp(V, 0.0, 0.0, A, J), sign);
    profile.set_peak_speed(sign * V);
    return profile;
  }
  const double jerks[3] = {ramp.jerk, 0.0, -ramp.jerk};
  const double lengths[3] = {ramp.rise, ramp.hold, ramp.fall};
  AxisState state = s;
  double position = stop_position(s, A, J);
  for (int k = 0;; ++k) {
    const AxisState next = after(state, jerks[k], lengths[k]);
    const double reached = k == 2 ? past : stop_position(next, A, J);
    if (reached < 0.0 && k < 2) {
      state = next;
      position = reached;
      continue;
    }
    const auto stops_at = [&](double t) { return stop_position(after(state, jerks[k], t), A, J); };
    const double t = zero_between(stops_at, 0.0, position, lengths[k], reached, rounding(s.q));
    add_broken_ramp(profile, s, ramp, {k, t}, sign, limits);
    return profile;
  }
}

// The highest speed of a motion from rest to rest over the distance D in the time T, which is not
// below the least.
double speed_in_time(double D, double T, const AxisLimits& limits) {
  const double A = limits.acceleration, J = limits.jerk;
  if (D < 2.0 * A * A * A / (J * J) || T >= D * J / (A * A) + 2.0 * A / J) {
    // If the acceleration limit is not reached: 2 y^3 / sqrt(J) - T y^2 + D = 0 with y = sqrt(V).
    const double root_J = std::sqrt(J);
    const auto f = [&](double y) { return D - y * y * (T - 2.0 * y / root_J); };
    const double lo = std::sqrt(D / T), hi = 0.25 * T * root_J;
    const double f_hi = f(hi);
    const double y = f_hi >= 0.0 ? hi : zero_between(f, lo, f(lo), hi, f_hi, 1e-16 * D);
    return y * y;
  }
  const double half = 0.5 * (T - A / J);
  return D / (half + std::sqrt(std::max(half * half - D / A, 0.0)));
}

void check_axes(std::span<const AxisState> from, std::span<const double> to,
                std::span<const AxisLimits> limits, std::size_t profiles) {
  const auto size = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
  check_size("to", size(to.size()), size(from.size()));
  check_size("limits", size(limits.size()), size(from.size()));
  check_size("profiles", size(profiles), size(from.size()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    const AxisState& s = from[i];
    if (!std::isfinite(s.q + s.v + s.a + to[i])) {
      throw ArgumentError(fmt::format("The state or the target of axis {} is not finite.", i + 1));
    }
    const AxisLimits& l = limits[i];
    if (!(l.speed > 0.0 && l.acceleration > 0.0 && l.jerk > 0.0) ||
        !std::isfinite(l.speed + l.acceleration + l.jerk)) {
      throw ArgumentError(
          fmt::format("Axis {} has limits of {}, {} and {} for speed, acceleration and jerk; a "
                      "motion of limited jerk needs all three, finite and above zero.",
                      i + 1, l.speed, l.acceleration, l.jerk));
    }
  }
}

}  // namespace

void JerkProfile::add(double duration, double jerk) {
  if (duration < kShortestStep) return;
  assert(count_ < kMostSteps);
  steps_[static_cast<std::size_t>(count_++)] = {duration, jerk};
  duration_ += duration;
}

JerkProfile fastest_jerk_limited(const AxisState& from, double to, const AxisLimits& limits) {
  if (from.v == 0.0 && from.a == 0.0) return rest_to_rest(to - from.q, limits, limits.speed);
  return from_motion(from, to, limits);
}

std::optional<JerkProfile> jerk_limited_in_time(const AxisState& from, double to,
                                                const AxisLimits& limits, double T,
                                                const JerkProfile& fastest) {
  if (T < fastest.duration()) return std::nullopt;
  if (from.v == 0.0 && from.a == 0.0) {
    const double D = std::abs(to - from.q);
    if (D == 0.0) return fastest;
    return rest_to_rest(to - from.q, limits, std::min(speed_in_time(D, T, limits), limits.speed));
  }
  const double sign = fastest.peak_speed() < 0.0 ? -1.0 : 1.0;
  const double highest = std::abs(fastest.peak_speed());
  if (highest == 0.0) return std::nullopt;
  const double A = limits.acceleration, J = limits.jerk;
  JerkProfile profile;
  const AxisState tamed = tame(from, limits, profile);
  const AxisState s = mirrored(tamed, to, sign);
  const double time = T - profile.duration();
  // For a constant speed w between the ramps: the remaining distance, minus the distance travelled
  // in the remaining time. It is zero for the right w.
  const auto missing = [&](double w) {
    const Ramp up = make_ramp(s.v, s.a, w, A, J);
    const Ramp down = make_ramp(w, 0.0, 0.0, A, J);
    const double left = -end_of_ramp({end_of_ramp(s, up, w), w, 0.0}, down, 0.0);
    return w * (time - up.duration() - down.duration()) - left;
  };
  const double at_highest = missing(highest);
  const double at_zero = missing(0.0);
  if (!(at_zero < 0.0 && at_highest >= 0.0)) return std::nullopt;
  const double w = zero_between(missing, 0.0, at_zero, highest, at_highest, rounding(s.q));
  const Ramp up = make_ramp(s.v, s.a, w, A, J);
  const Ramp down = make_ramp(w, 0.0, 0.0, A, J);
  const double cruise = time - up.duration() - down.duration();
  if (cruise < -1e-12) return std::nullopt;
  add_ramp(profile, up, sign);
  profile.add(cruise, 0.0);
  add_ramp(profile, down, sign);
  profile.set_peak_speed(sign * w);
  return profile;
}

double plan_jerk_limited(std::span<const AxisState> from, std::span<const double> to,
                         std::span<const AxisLimits> limits, std::span<JerkProfile> profiles) {
  check_axes(from, to, limits, profiles.size());
  double T = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    profiles[i] = fastest_jerk_limited(from[i], to[i], limits[i]);
    T = std::max(T, profiles[i].duration());
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (profiles[i].duration() == T) continue;
    if (auto slower = jerk_limited_in_time(from[i], to[i], limits[i], T, profiles[i])) {
      profiles[i] = *slower;
    }
  }
  return T;
}

std::vector<Segment> jerk_segments(const AxisState& from, const JerkProfile& profile) {
  std::vector<Segment> pieces;
  pieces.reserve(profile.steps().size());
  AxisState s = from;
  double t = 0.0;
  for (const JerkStep& step : profile.steps()) {
    pieces.push_back({.start = t,
                      .duration = step.duration,
                      .degree = 3,
                      .c = {s.q, s.v, 0.5 * s.a, step.jerk / 6.0}});
    s = after(s, step.jerk, step.duration);
    t += step.duration;
  }
  return pieces;
}

Trajectory jerk_trajectory(std::span<const AxisState> from, std::span<const double> to,
                           std::span<const JerkProfile> profiles, double duration) {
  std::vector<JointPath> joints;
  joints.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    joints.push_back({.segments = jerk_segments(from[i], profiles[i]), .q_end = to[i]});
  }
  return {std::move(joints), duration};
}

}  // namespace armlet
