// Common functions of the planners: reading a request, and its duration.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "armlet/trajectory/jerk_limited.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// The shortest duration of a motion is the resolution of the clock, one nanosecond.
constexpr double kShortestMotion = 1e-9;

// The travel of joint i; 0 if it is as small as rounding errors: the joint then stays at rest and
// ends exactly on its target.
double travel_of(const MoveRequest& request, int i);
const AxisLimits& limits_of(const MoveRequest& request, int i);
double limit_value(const AxisLimits& limits, LimitKind kind);
// Whether no joint travels and there are no points in between.
bool stands_still(const MoveRequest& request);

// The duration of the whole motion, and the limit that it exceeds.
struct Duration {
  double T = 0.0;
  std::optional<TooFast> too_fast{};
  bool possible = true;
};

// The duration for a request, if the slowest joint needs slowest.least_time.
// throws  ArgumentError if neither a limit nor a time determines it.
Duration choose_duration(const MoveRequest& request, TooFast slowest);

// The limits on speed and jerk, and on the acceleration of joints without a known motor; infinite
// for others.
std::vector<AxisLimits> limits_beside_motors(const MoveRequest& request);

// The joint whose limit a motion comes closest to: that of its motor, if request.motors is set, or
// one of `axes`; jerk limits are included if they apply.
TooFast tightest_joint(const MoveRequest& request, std::span<const AxisLimits> axes,
                       const Trajectory& motion, Jerk jerk);

// Planners of planner_shapes.cpp: one curve through all points with a fixed form of its speed.
Plan plan_cubic_interpolator(const MoveRequest& request);
Plan plan_spline_3(const MoveRequest& request);
Plan plan_spline_4(const MoveRequest& request);
Plan plan_spline_5(const MoveRequest& request);
Plan plan_434(const MoveRequest& request);
Plan plan_353(const MoveRequest& request);
Plan plan_five_cubics(const MoveRequest& request);

// Planners of planner_joint.cpp.
Plan plan_one_by_one(const MoveRequest& request);     // Seq
Plan plan_without_ramps(const MoveRequest& request);  // Lin0
Plan plan_limited_jerk(const MoveRequest& request);   // SCurve

// A motion of all joints from rest to rest by phases of constant jerk, the fastest within these
// limits.
struct PhasedMove {
  std::vector<AxisState> from{};
  std::vector<double> to{};
  std::vector<JerkProfile> profiles{};
  double T = 0.0;

  [[nodiscard]] Trajectory trajectory() const { return jerk_trajectory(from, to, profiles, T); }
};
PhasedMove phased_move(const MoveRequest& request, std::span<const AxisLimits> limits);

// A function of planner_motors.cpp: the shortest motion found within the limits on speed and jerk
// and the force limits of request.motors, which replace the acceleration limits of their joints. It
// is never longer than the motion of plan_limited_jerk slowed down until the motors suffice. Empty
// if the motors cannot hold the arm at some position.
std::optional<Trajectory> limited_jerk_with_motors(const MoveRequest& request);

// The planner of planner_fastest.cpp.
Plan plan_fastest(const MoveRequest& request);

// The planner of planner_modified_sine.cpp.
Plan plan_modified_sine(const MoveRequest& request);

// Applies the planner from point to point, with a stop at each.
Plan plan_legs(const Planner& planner, const MoveRequest& request);

}  // namespace armlet
