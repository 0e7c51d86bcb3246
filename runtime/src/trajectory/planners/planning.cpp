#include "trajectory/planners/planning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "trajectory/cube_root.hpp"

namespace armlet {
namespace {

// A time that was computed from a limit may be requested again, so rounding errors must not make it
// too short.
constexpr double kTimeSlack = 1e-9;
constexpr double kNoTravel = 1e-12;  // rad or m

}  // namespace

double travel_of(const MoveRequest& request, int i) {
  const double D = request.q1[i] - request.q0[i];
  return std::abs(D) < kNoTravel ? 0.0 : D;
}

const AxisLimits& limits_of(const MoveRequest& request, int i) {
  return request.limits[static_cast<size_t>(i)];
}

double limit_value(const AxisLimits& limits, LimitKind kind) {
  switch (kind) {
    case LimitKind::kSpeed:
      return limits.speed;
    case LimitKind::kAcceleration:
      return limits.acceleration;
    case LimitKind::kJerk:
      return limits.jerk;
    case LimitKind::kForce:
      return 0.0;  // the limit of a motor, which is not one of the axis
  }
  return 0.0;
}

bool stands_still(const MoveRequest& request) {
  for (int i = 0; i < request.q0.size(); ++i) {
    if (travel_of(request, i) != 0.0) return false;
  }
  return request.via.empty();
}

Duration choose_duration(const MoveRequest& request, TooFast slowest) {
  if (!request.time) {
    if (slowest.least_time < kShortestMotion) {
      throw ArgumentError("The joints have no limits, so the move needs a time.");
    }
    return {.T = slowest.least_time};
  }
  slowest.given = *request.time;
  const bool too_fast = slowest.given < slowest.least_time * (1.0 - kTimeSlack);
  const bool possible = slowest.given >= kShortestMotion && !(too_fast && request.enforce_limits);
  return {.T = slowest.given,
          .too_fast = too_fast || !possible ? std::optional(slowest) : std::nullopt,
          .possible = possible};
}

std::vector<AxisLimits> limits_beside_motors(const MoveRequest& request) {
  std::vector<AxisLimits> limits = request.limits;
  for (int i = 0; request.motors != nullptr && i < request.motors->n(); ++i) {
    if (std::isfinite(request.motors->joint(i).max_effort))
      limits[static_cast<std::size_t>(i)].acceleration = std::numeric_limits<double>::infinity();
  }
  return limits;
}

TooFast tightest_joint(const MoveRequest& request, std::span<const AxisLimits> axes,
                       const Trajectory& motion, Jerk jerk) {
  TooFast out{.least_time = motion.duration()};
  double most = -1.0;
  if (request.motors != nullptr) {
    const MotionForces forces = motion_forces(*request.motors, motion);
    if (forces.nearest >= 0) {
      const PeakForce& peak = forces.peaks[static_cast<std::size_t>(forces.nearest)];
      most = peak.share();
      out.joint = forces.nearest;
      out.travel = travel_of(request, forces.nearest);
      out.kind = LimitKind::kForce;
      out.limit = peak.limit;
    }
  }
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& limits = axes[static_cast<std::size_t>(i)];
    const auto consider = [&](LimitKind kind, double load) {
      if (load <= most) return;
      most = load;
      out.joint = i;
      out.travel = travel_of(request, i);
      out.kind = kind;
      out.limit = limit_value(limits, kind);
    };
    consider(LimitKind::kAcceleration, std::sqrt(motion.peak(i, 2) / limits.acceleration));
    consider(LimitKind::kSpeed, motion.peak(i, 1) / limits.speed);
    if (jerk == Jerk::kFree) continue;
    consider(LimitKind::kJerk, cube_root(motion.peak(i, 3) / limits.jerk));
  }
  return out;
}

namespace {

// The joint that comes closest to its speed limit.
TooFast busiest_joint(const MoveRequest& request, const Trajectory& motion) {
  TooFast busiest{.limit = limits_of(request, 0).speed};
  double highest = 0.0;
  for (int i = 0; i < motion.n(); ++i) {
    const double load = motion.peak(i, 1) / limits_of(request, i).speed;
    if (load <= highest) continue;
    highest = load;
    busiest = {.joint = i, .travel = travel_of(request, i), .limit = limits_of(request, i).speed};
  }
  return busiest;
}

}  // namespace

Plan plan_legs(const Planner& planner, const MoveRequest& request) {
  MoveRequest leg{.q0 = request.q0, .limits = request.limits};
  leg.enforce_limits = request.enforce_limits;
  leg.motors = request.motors;
  Plan whole;
  for (std::size_t k = 0; k <= request.via.size(); ++k) {
    leg.q1 = k < request.via.size() ? request.via[k] : request.q1;
    if (!request.durations.empty()) leg.time = request.durations[k];
    Plan plan = planner(leg);
    if (plan.too_fast && !whole.too_fast) whole.too_fast = plan.too_fast;
    if (!plan.trajectory) return {.too_fast = plan.too_fast};
    whole.trajectory =
        whole.trajectory ? whole.trajectory->then(*plan.trajectory) : std::move(plan.trajectory);
    leg.q0 = leg.q1;
  }
  const double least = whole.trajectory->duration();
  if (!request.durations.empty() || least == 0.0) return whole;
  TooFast busiest = busiest_joint(request, *whole.trajectory);
  busiest.least_time = least;
  const Duration chosen = choose_duration(request, busiest);
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  return {.trajectory = whole.trajectory->stretched(chosen.T / least), .too_fast = chosen.too_fast};
}

}  // namespace armlet
