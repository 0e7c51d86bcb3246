// What the planners share: reading a request, and the duration it leads to.
#pragma once

#include <optional>

#include "armlet/trajectory/planner.hpp"

namespace armlet {

// Shorter motions than one nanosecond do not exist on the clock.
constexpr double kShortestMotion = 1e-9;

// Travel of joint i; below rounding it is 0: the joint stands still and ends exactly on its target.
double travel_of(const MoveRequest& request, int i);
const AxisLimits& limits_of(const MoveRequest& request, int i);
double limit_value(const AxisLimits& limits, LimitKind kind);
// No joint travels, and there are no points in between.
bool stands_still(const MoveRequest& request);

// The duration of the whole motion, and what is exceeded by it.
struct Duration {
  double T = 0.0;
  std::optional<TooFast> too_fast{};
  bool possible = true;
};

// The duration that a request leads to when the slowest joint needs slowest.least_time.
// throws  ArgumentError when neither a limit nor a time decides.
Duration choose_duration(const MoveRequest& request, TooFast slowest);

// Planners of planner_shapes.cpp: one curve through all points, whatever its speed.
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

// The planner of planner_fastest.cpp.
Plan plan_fastest(const MoveRequest& request);

// The planner of planner_modified_sine.cpp.
Plan plan_modified_sine(const MoveRequest& request);

// The planner applied from point to point, stopping at each.
Plan plan_legs(const Planner& planner, const MoveRequest& request);

}  // namespace armlet
