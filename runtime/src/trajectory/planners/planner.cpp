#include "armlet/trajectory/planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/trajectory/cartesian_spline.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

using LeastTimeLaw = LeastTime (*)(double travel, const AxisLimits& limits);
using PathLaw = std::vector<Segment> (*)(double q0, double q1, double T, const AxisLimits& limits);

// The law of one axis: its least time, and its pieces for a given time.
struct AxisLaw {
  LeastTimeLaw least_time;
  PathLaw pieces;
};

void check_durations(const MoveRequest& request) {
  check_size("durations", static_cast<Eigen::Index>(request.durations.size()),
             static_cast<Eigen::Index>(request.via.size() + 1));
  for (const double T : request.durations) {
    if (std::isfinite(T) && T >= kShortestMotion) continue;
    throw ArgumentError(fmt::format("A leg of {} s cannot be made; expected more than 0 s.", T));
  }
  if (request.time || request.speed) {
    throw ArgumentError("A move was given durations together with a time or a speed.");
  }
}

void check_request(const MoveRequest& request) {
  check_size("q1", request.q1.size(), request.q0.size());
  check_size("limits", static_cast<Eigen::Index>(request.limits.size()), request.q0.size());
  check_finite("q0", request.q0);
  check_finite("q1", request.q1);
  if (request.motors != nullptr) check_size("motors", request.motors->n(), request.q0.size());
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
  for (const Eigen::VectorXd& point : request.via) {
    check_size("via", point.size(), request.q0.size());
    check_finite("via", point);
  }
  if (!request.durations.empty()) check_durations(request);
}

// The request with its speed limits multiplied by the requested fraction. The fastest motion within
// these limits keeps the fraction. A motion that is only slowed down may not: a trapezoid with
// longer ramps has a higher constant speed.
MoveRequest with_scaled_speeds(MoveRequest request) {
  if (!request.speed) return request;
  for (AxisLimits& limits : request.limits) limits.speed *= *request.speed;
  request.speed.reset();
  return request;
}

// The joint that needs the longest time, and the limit that decides it.
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

// Plans every joint with `law`. Synchronous motions take the same time for all joints. Otherwise
// the time of each joint is its own least time, multiplied by the factor by which the slowest one
// was stretched.
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
    // A joint without limits has no least time, so it takes the time of the whole motion.
    if (!synchronous && slowest.least_time > 0.0) {
      const double own = law.least_time(travel, limits).time;
      if (own > 0.0) T = std::max(chosen.T * (own / slowest.least_time), kShortestMotion);
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

std::vector<Segment> septic_path(double q0, double q1, double T, const AxisLimits&) {
  return {septic_segment(q0, q1, T)};
}

std::vector<Segment> cycloid_path(double q0, double q1, double T, const AxisLimits&) {
  return cycloid_segments(q0, q1, T);
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
constexpr AxisLaw kSeptic{septic_least_time, septic_path};
constexpr AxisLaw kCycloid{cycloid_least_time, cycloid_path};

// Limits of the scalar s in q = q0 + s (q1 - q0): for each, that of the most restrictive joint.
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

// The joint whose limit determines the scalar law.
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

// The fastest motion of the law, for all joints together or for each by itself.
template <const AxisLaw& kLaw, bool kTogether>
Plan plan_law(const MoveRequest& request) {
  return plan_by_law(request, kLaw, kTogether);
}

Plan plan_cubic(const MoveRequest& request) {
  return request.via.empty() ? plan_by_law(request, kCubic, true)
                             : plan_cubic_interpolator(request);
}

constexpr PlannerRow kPlanners[] = {
    {.name = "Syn",
     .does = "all joints start and end together; a law of fifth order, speed and acceleration zero "
             "at both ends",
     .plan = plan_law<kQuintic, true>,
     .smooth = 2},
    {.name = "Asyn",
     .does = "the same law, but every joint at its own limit, stopping when it arrives; a time "
             "belongs to the slowest, and all joints take the same fraction of their limits",
     .plan = plan_law<kQuintic, false>,
     .smooth = 2},
    {.name = "Lin",
     .does = "a straight line of the joints at constant speed (for `moveC`: a straight line in "
             "space); the ramps at the ends are as short as the accelerations allow",
     .plan = plan_lin,
     .smooth = 1},
    {.name = "Cubic",
     .does = "together, a law of third order; through several points a curve that never swings out",
     .plan = plan_cubic,
     .through = Through::kAllPoints,
     .smooth = 1,
     .in_space = SplineKind::kCubic},
    {.name = "Spline3",
     .does = "a spline of third order through several points",
     .plan = plan_spline_3,
     .through = Through::kAllPoints,
     .smooth = 1,
     .in_space = SplineKind::kSpline3},
    {.name = "Spline4",
     .does = "a spline of fourth order through several points; the acceleration is zero at both "
             "ends",
     .plan = plan_spline_4,
     .through = Through::kAllPoints,
     .smooth = 2,
     .in_space = SplineKind::kSpline4},
    {.name = "Spline5",
     .does = "a spline of fifth order through several points; the acceleration is zero at both "
             "ends",
     .plan = plan_spline_5,
     .through = Through::kAllPoints,
     .smooth = 2,
     .in_space = SplineKind::kSpline5},
    {.name = "434",
     .does = "lift-off, travel and set-down, polynomials of order 4, 3 and 4 through four points; "
             "from two points the joints lift off and set down by a tenth of the way, without "
             "durations 1:2:1",
     .plan = plan_434,
     .through = Through::kAllPoints,
     .smooth = 2},
    {.name = "Trap",
     .does = "together, trapezoidal speed; with a time a quarter of it to speed up and to slow "
             "down if the limits allow, otherwise ramps at the acceleration limit",
     .plan = plan_law<kTrapezoid, true>,
     .smooth = 1},
    {.name = "353",
     .does = "as `434`, of orders 3, 5 and 3",
     .plan = plan_353,
     .through = Through::kAllPoints,
     .smooth = 2},
    {.name = "FiveCubic",
     .does = "as `434`, of five cubics",
     .plan = plan_five_cubics,
     .through = Through::kAllPoints,
     .smooth = 2},
    {.name = "SCurve",
     .does = "limited jerk: every joint as fast as its limits on speed, acceleration and jerk "
             "allow, then slowed down to the duration of the slowest; inside `with (torques: "
             "\"limit\")` what motors give counts in the place of accelerations",
     .plan = plan_limited_jerk,
     .smooth = 2},
    {.name = "Fastest",
     .does = "a spline through all points, run as fast as speeds and accelerations allow "
             "everywhere, to 0.5 %; accelerations jump; inside `with (torques: \"limit\")` as "
             "fast as the motors can",
     .plan = plan_fastest,
     .through = Through::kAllPoints,
     .smooth = 1},
    {.name = "Septic",
     .does = "as `Syn`, of seventh order; the jerk too is zero at both ends",
     .plan = plan_law<kSeptic, true>,
     .smooth = 3},
    {.name = "Cycloid",
     .does = "as `Syn`; the acceleration is a sine",
     .plan = plan_law<kCycloid, true>,
     .smooth = 2},
    {.name = "ModSine",
     .does = "as `Syn`; the acceleration is a sine that is three times slower in between than at "
             "the ends: its peak is lower than that of `Cycloid`, and the load changes gently",
     .plan = plan_modified_sine,
     .smooth = 2},
    {.name = "Seq",
     .does = "one joint after another, each with the law of `Syn`",
     .plan = plan_one_by_one,
     .smooth = 2},
    {.name = "Lin0",
     .does = "constant speed without ramps, for study; no robot executes it",
     .plan = plan_without_ramps},
};

}  // namespace

std::span<const PlannerRow> planner_rows() { return kPlanners; }

std::shared_ptr<const PlannerSet::Entries> PlannerSet::built_in() {
  Entries all;
  for (const PlannerRow& row : kPlanners)
    all.push_back({std::string(row.name), row.plan, row.through});
  return std::make_shared<const Entries>(std::move(all));
}

PlannerSet::PlannerSet() {
  static const std::shared_ptr<const Entries> all = built_in();
  planners_ = all;
}

void PlannerSet::add(std::string name, Planner planner, Through through) {
  auto changed = std::make_shared<Entries>(*planners_);
  const auto same = std::ranges::find(*changed, name, &Entry::name);
  if (same != changed->end()) {
    *same = {std::move(name), std::move(planner), through};
  } else {
    changed->push_back({std::move(name), std::move(planner), through});
  }
  planners_ = std::move(changed);
}

const PlannerSet::Entry* PlannerSet::find(std::string_view name) const {
  const auto found = std::ranges::find(*planners_, name, &Entry::name);
  return found == planners_->end() ? nullptr : &*found;
}

bool PlannerSet::has(std::string_view name) const { return find(name) != nullptr; }

std::vector<std::string> PlannerSet::names() const {
  std::vector<std::string> names;
  for (const Entry& entry : *planners_) names.push_back(entry.name);
  return names;
}

Plan PlannerSet::plan(std::string_view name, const MoveRequest& request) const {
  const Entry* entry = find(name);
  if (entry == nullptr) {
    throw ArgumentError(
        fmt::format("No planner is called '{}'; there are {}.", name, fmt::join(names(), ", ")));
  }
  check_request(request);
  const MoveRequest slowed = with_scaled_speeds(request);
  if (entry->through == Through::kAllPoints) return entry->plan(slowed);
  if (request.via.empty() && request.durations.empty()) return entry->plan(slowed);
  return plan_legs(entry->plan, slowed);
}

}  // namespace armlet
