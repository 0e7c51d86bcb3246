#include "armlet/trajectory/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

// Shorter motions than one nanosecond do not exist on the clock.
constexpr double kShortest = 1e-9;
// A time computed from a limit may be given back as a time: rounding must not make it too short.
constexpr double kTimeSlack = 1e-9;
// Travel below this is rounding; the joint stands still and ends exactly on its target.
constexpr double kNoTravel = 1e-12;

constexpr std::array<std::string_view, 6> kPlannedNames = {"Spline3", "Spline4", "Spline5",
                                                           "434",     "353",     "Lin0"};

using LeastTimeLaw = LeastTime (*)(double travel, const AxisLimits& limits);
using PathLaw = std::vector<Segment> (*)(double q0, double q1, double T, const AxisLimits& limits);

// One axis law: how long it needs at least, and its pieces for a given time.
struct AxisLaw {
  LeastTimeLaw least_time;
  PathLaw pieces;
};

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
  }
  return 0.0;
}

void check_request(const MoveRequest& request) {
  check_size("q1", request.q1.size(), request.q0.size());
  check_size("limits", static_cast<Eigen::Index>(request.limits.size()), request.q0.size());
  check_finite("q0", request.q0);
  check_finite("q1", request.q1);
  for (const AxisLimits& limits : request.limits) {
    if (!(limits.speed > 0.0) || !(limits.acceleration > 0.0) || !(limits.jerk > 0.0)) {
      throw ArgumentError("The limits of a joint must be above zero.");
    }
  }
  if (request.time && (!std::isfinite(*request.time) || *request.time < 0.0)) {
    throw ArgumentError(
        fmt::format("The time of a move is {} s; expected 0 s or more.", *request.time));
  }
  if (request.speed && !(*request.speed > 0.0 && *request.speed <= 1.0)) {
    throw ArgumentError(
        fmt::format("The speed of a move is {}; expected a fraction of the joint limits, above 0 "
                    "and at most 1.",
                    *request.speed));
  }
  if (request.time && request.speed) {
    throw ArgumentError("A move was given both a time and a speed; give one of them.");
  }
}

// The joint that needs longest, and why.
TooFast slowest_joint(const MoveRequest& request, const AxisLaw& law) {
  TooFast slowest{.joint = 0, .limit = limit_value(limits_of(request, 0), LimitKind::kSpeed)};
  for (int i = 0; i < request.q0.size(); ++i) {
    const LeastTime least = law.least_time(travel_of(request, i), limits_of(request, i));
    if (least.time <= slowest.least_time) continue;
    slowest = {.joint = i,
               .given = 0.0,
               .least_time = least.time,
               .travel = travel_of(request, i),
               .kind = least.limit,
               .limit = limit_value(limits_of(request, i), least.limit)};
  }
  return slowest;
}

bool stands_still(const MoveRequest& request) {
  for (int i = 0; i < request.q0.size(); ++i) {
    if (travel_of(request, i) != 0.0) return false;
  }
  return true;
}

// The duration of the whole motion, and what is exceeded by it.
struct Duration {
  double T = 0.0;
  std::optional<TooFast> too_fast{};
  bool possible = true;
};

Duration choose_duration(const MoveRequest& request, TooFast slowest) {
  if (!request.time) {
    const double T = slowest.least_time / request.speed.value_or(1.0);
    if (T < kShortest) {
      throw ArgumentError("The joints have no limits, so the move needs a time.");
    }
    return {.T = T};
  }
  slowest.given = *request.time;
  const bool too_fast = slowest.given < slowest.least_time * (1.0 - kTimeSlack);
  const bool possible = slowest.given >= kShortest && !(too_fast && request.enforce_limits);
  return {.T = slowest.given,
          .too_fast = too_fast || !possible ? std::optional(slowest) : std::nullopt,
          .possible = possible};
}

// Plans every joint with `law`. Synchronous: all take the whole time. Otherwise each takes the time
// it needs, multiplied by how much the slowest was stretched.
Plan plan_by_law(const MoveRequest& request, const AxisLaw& law, bool synchronous) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  const TooFast slowest = slowest_joint(request, law);
  const Duration chosen = choose_duration(request, slowest);
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  std::vector<JointPath> joints;
  for (int i = 0; i < request.q0.size(); ++i) {
    JointPath path{.q_end = request.q1[i]};
    const AxisLimits& limits = limits_of(request, i);
    const double travel = travel_of(request, i);
    double T = chosen.T;
    // A joint without limits needs no time of its own; it takes the whole.
    if (!synchronous && slowest.least_time > 0.0) {
      const double own = law.least_time(travel, limits).time;
      if (own > 0.0) T = std::max(chosen.T * (own / slowest.least_time), kShortest);
    }
    if (travel != 0.0) path.segments = law.pieces(request.q0[i], request.q1[i], T, limits);
    joints.push_back(std::move(path));
  }
  return {.trajectory = Trajectory(std::move(joints), chosen.T), .too_fast = chosen.too_fast};
}

std::vector<Segment> quintic_path(double q0, double q1, double T, const AxisLimits&) {
  return {quintic_segment({.q = q0}, {.q = q1}, T)};
}

std::vector<Segment> cubic_path(double q0, double q1, double T, const AxisLimits&) {
  return {cubic_segment({.q = q0}, {.q = q1}, T)};
}

std::vector<Segment> trapezoid_path(double q0, double q1, double T, const AxisLimits& limits) {
  const Trapezoid quarter = trapezoid_with_ramp(q1 - q0, T, 0.25 * T);
  const bool allowed =
      quarter.speed <= limits.speed && quarter.speed <= limits.acceleration * quarter.ramp;
  const auto steep = allowed ? std::nullopt : trapezoid_in_time(q1 - q0, T, limits.acceleration);
  return trapezoid_segments(q0, q1 - q0, steep.value_or(quarter));
}

constexpr AxisLaw kQuintic{quintic_least_time, quintic_path};
constexpr AxisLaw kCubic{cubic_least_time, cubic_path};
constexpr AxisLaw kTrapezoid{trapezoid_least_time, trapezoid_path};

// Limits of the scalar s in q = q0 + s (q1 - q0): what the most demanding joint leaves.
AxisLimits scalar_limits(const MoveRequest& request) {
  AxisLimits scalar;
  for (int i = 0; i < request.q0.size(); ++i) {
    const double D = std::abs(travel_of(request, i));
    if (D == 0.0) continue;
    scalar.speed = std::min(scalar.speed, limits_of(request, i).speed / D);
    scalar.acceleration = std::min(scalar.acceleration, limits_of(request, i).acceleration / D);
  }
  return scalar;
}

// The joint whose limit decides about the scalar law.
TooFast scalar_bottleneck(const MoveRequest& request, const AxisLimits& scalar) {
  const LeastTime least = trapezoid_least_time(1.0, scalar);
  TooFast bottleneck{.least_time = least.time, .kind = least.limit};
  const double tightest = limit_value(scalar, least.limit);
  for (int i = static_cast<int>(request.q0.size()) - 1; i >= 0; --i) {
    const double D = std::abs(travel_of(request, i));
    const double limit = limit_value(limits_of(request, i), least.limit);
    if (D == 0.0 || limit / D > tightest) continue;
    bottleneck.joint = i;
    bottleneck.travel = travel_of(request, i);
    bottleneck.limit = limit;
  }
  return bottleneck;
}

Plan plan_lin(const MoveRequest& request) {
  if (stands_still(request)) return plan_by_law(request, kTrapezoid, true);
  const AxisLimits scalar = scalar_limits(request);
  const Duration chosen = choose_duration(request, scalar_bottleneck(request, scalar));
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  const Trapezoid shape = trapezoid_in_time(1.0, chosen.T, scalar.acceleration)
                              .value_or(trapezoid_with_ramp(1.0, chosen.T, 0.25 * chosen.T));
  std::vector<JointPath> joints;
  for (int i = 0; i < request.q0.size(); ++i) {
    const double travel = travel_of(request, i);
    JointPath path{.q_end = request.q1[i]};
    Trapezoid own = shape;
    own.speed *= std::abs(travel);
    if (travel != 0.0) path.segments = trapezoid_segments(request.q0[i], travel, own);
    joints.push_back(std::move(path));
  }
  return {.trajectory = Trajectory(std::move(joints), chosen.T), .too_fast = chosen.too_fast};
}

}  // namespace

PlannerSet::PlannerSet() {
  add("Syn", [](const MoveRequest& request) { return plan_by_law(request, kQuintic, true); });
  add("Asyn", [](const MoveRequest& request) { return plan_by_law(request, kQuintic, false); });
  add("Lin", plan_lin);
  add("Cubic", [](const MoveRequest& request) { return plan_by_law(request, kCubic, true); });
  add("Trap", [](const MoveRequest& request) { return plan_by_law(request, kTrapezoid, true); });
}

void PlannerSet::add(std::string name, Planner planner) {
  const auto same = std::ranges::find(planners_, name, &std::pair<std::string, Planner>::first);
  if (same != planners_.end()) {
    same->second = std::move(planner);
  } else {
    planners_.emplace_back(std::move(name), std::move(planner));
  }
}

const Planner* PlannerSet::find(std::string_view name) const {
  const auto found = std::ranges::find(planners_, name, &std::pair<std::string, Planner>::first);
  return found == planners_.end() ? nullptr : &found->second;
}

Availability PlannerSet::availability(std::string_view name) const {
  if (find(name) != nullptr) return Availability::kAvailable;
  return std::ranges::find(kPlannedNames, name) == kPlannedNames.end() ? Availability::kUnknown
                                                                       : Availability::kNotYet;
}

std::vector<std::string> PlannerSet::names() const {
  std::vector<std::string> names;
  for (const auto& [name, planner] : planners_) names.push_back(name);
  return names;
}

Plan PlannerSet::plan(std::string_view name, const MoveRequest& request) const {
  const Planner* planner = find(name);
  if (planner == nullptr) {
    throw ArgumentError(
        fmt::format("No planner is called '{}'; there are {}.", name, fmt::join(names(), ", ")));
  }
  check_request(request);
  return (*planner)(request);
}

}  // namespace armlet
