// The fastest motion of an axis under limits on speed, acceleration and jerk, from any state to
// rest.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "armlet/trajectory/profile.hpp"

namespace armlet {

// An interval of constant jerk.
struct JerkStep {
  double duration = 0.0;  // s, > 0
  double jerk = 0.0;      // rad/s^3 or m/s^3
};

// Motion of one axis as a sequence of constant jerks, without allocation.
class JerkProfile {
 public:
  // One step to bring an acceleration back to its limit, three up, a cruise, three down.
  static constexpr int kMostSteps = 8;

  [[nodiscard]] std::span<const JerkStep> steps() const {
    return {steps_.data(), static_cast<std::size_t>(count_)};
  }
  [[nodiscard]] double duration() const { return duration_; }
  // The highest or lowest speed, with sign, at which the acceleration is zero before it stops; 0 if
  // it only decelerates.
  [[nodiscard]] double peak_speed() const { return peak_speed_; }

  // Adds a step; one of negligible duration is left out.
  void add(double duration, double jerk);
  void set_peak_speed(double v) { peak_speed_ = v; }

 private:
  std::array<JerkStep, kMostSteps> steps_{};
  int count_ = 0;
  double duration_ = 0.0;
  double peak_speed_ = 0.0;
};

// The fastest motion from `from` to rest at `to`. All three limits are finite and above zero. A
// start with a speed or an acceleration above its limit is first brought back within the limits; a
// start that cannot avoid exceeding the speed limit exceeds it as little as possible.
//
// The axis accelerates towards a speed limit up to some instant and then stops as fast as possible.
// The position where it stops is a monotonic function of that instant, which is found by
// bracketing.
//
// from, to  state, rad or m and its derivatives, and target; finite.
// throws    nothing; plan_jerk_limited checks the arguments.
// source    L. Berscheid, T. Kroeger, Jerk-limited real-time trajectory generation with arbitrary
//           target states, RSS 2021, for targets at rest.
JerkProfile fastest_jerk_limited(const AxisState& from, double to, const AxisLimits& limits);

// The motion of jerk_limited in exactly T seconds, with a lower speed between the same
// accelerations and jerks; nothing if there is none (T too short, or a start that must first
// decelerate).
//
// T        s. fastest  of the same from, to and limits.
std::optional<JerkProfile> jerk_limited_in_time(const AxisState& from, double to,
                                                const AxisLimits& limits, double T,
                                                const JerkProfile& fastest);

// Moves all axes to rest: the fastest motion of each, slowed down to the duration of the slowest
// axis. An axis that cannot be slowed down ends earlier and waits.
//
// profiles  receives one profile per axis.
// returns   the duration, s.
// throws    ArgumentError for sizes that differ, numbers or limits that are not finite, or limits
//           that are not above zero.
double plan_jerk_limited(std::span<const AxisState> from, std::span<const double> to,
                         std::span<const AxisLimits> limits, std::span<JerkProfile> profiles);

// The cubic pieces of a profile that starts in the given state at t = 0: position is the third
// integral of the constant jerks.
std::vector<Segment> jerk_segments(const AxisState& from, const JerkProfile& profile);

// The motion of several axes; `from` and `to` as in plan_jerk_limited, duration in s.
//
// throws  ArgumentError as the constructor of Trajectory does.
Trajectory jerk_trajectory(std::span<const AxisState> from, std::span<const double> to,
                           std::span<const JerkProfile> profiles, double duration);

}  // namespace armlet
