// The planner Fastest: one curve through all points, run as fast as the limits allow everywhere.

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

constexpr double kSamePoint = 1e-12;  // rad or m
// Positions at which speeds are found: with them the motion takes 0.5 % longer than it had to, at
// most.
constexpr int kIntervalsPerLeg = 60;
constexpr int kFewestIntervals = 240;

// The points without those that repeat the one before.
std::vector<Eigen::VectorXd> different_points(const MoveRequest& request) {
  std::vector<Eigen::VectorXd> points = {request.q0};
  const auto add = [&](const Eigen::VectorXd& q) {
    if ((q - points.back()).cwiseAbs().maxCoeff() > kSamePoint) points.push_back(q);
  };
  for (const Eigen::VectorXd& q : request.via) add(q);
  add(request.q1);
  return points;
}

// The joint whose limit is met most closely.
TooFast tightest_joint(const MoveRequest& request, const Trajectory& motion) {
  TooFast out{.least_time = motion.duration()};
  double most = -1.0;
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& limits = limits_of(request, i);
    const double by_speed = motion.peak(i, 1) / limits.speed;
    const double by_acceleration = std::sqrt(motion.peak(i, 2) / limits.acceleration);
    if (std::max(by_speed, by_acceleration) <= most) continue;
    most = std::max(by_speed, by_acceleration);
    out.joint = i;
    out.travel = travel_of(request, i);
    out.kind = by_speed > by_acceleration ? LimitKind::kSpeed : LimitKind::kAcceleration;
    out.limit = limit_value(limits, out.kind);
  }
  return out;
}

}  // namespace

Plan plan_fastest(const MoveRequest& request) {
  if (!request.durations.empty()) {
    throw ArgumentError(
        "The planner Fastest divides the time among the legs by itself; leave durations out.");
  }
  const std::vector<Eigen::VectorXd> points = different_points(request);
  if (points.size() < 2)
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  const int intervals =
      std::max(kFewestIntervals, kIntervalsPerLeg * static_cast<int>(points.size() - 1));
  const Trajectory fastest = time_optimal(path_through(points), request.limits, intervals);
  const Duration chosen = choose_duration(request, tightest_joint(request, fastest));
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  return {.trajectory = fastest.stretched(chosen.T / fastest.duration()),
          .too_fast = chosen.too_fast};
}

}  // namespace armlet
