// Planners that make one curve through all points, and then scale its time to the request.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/spline.hpp"
#include "trajectory/cube_root.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

using Curve = std::vector<Segment> (*)(std::span<const double> t, std::span<const double> q,
                                       const PathEnds& ends);

// curve       makes the pieces through given points at given times.
// three_legs  whether it consists of lift-off, travel and set-down.
// smooth      whether its acceleration is continuous from rest to rest, so that jerk limits apply.
struct Shape {
  const char* name;
  Curve curve;
  bool three_legs;
  bool smooth;
};

std::vector<Eigen::VectorXd> points_of(const MoveRequest& request, const Shape& shape) {
  std::vector<Eigen::VectorXd> points = {request.q0};
  points.insert(points.end(), request.via.begin(), request.via.end());
  points.push_back(request.q1);
  if (!shape.three_legs) return points;
  if (points.size() == 2) {
    const Eigen::VectorXd D = request.q1 - request.q0;
    points.insert(points.begin() + 1, {request.q0 + 0.1 * D, request.q0 + 0.9 * D});
  }
  if (points.size() != 4) {
    throw ArgumentError(fmt::format(
        "The planner {} goes through 2 or 4 points: start, lift-off, set-down and end; {} were "
        "given.",
        shape.name, points.size()));
  }
  return points;
}

// The times of the points, from 0. Times that are not given are distributed in proportion to the
// durations of the segments at the speed limits; a segment without travel gets a hundredth.
std::vector<double> times_of(const MoveRequest& request, const Shape& shape,
                             const std::vector<Eigen::VectorXd>& points) {
  std::vector<double> legs(points.size() - 1, 1.0);
  if (request.durations.size() == legs.size()) {
    legs = request.durations;
  } else if (shape.three_legs) {
    legs = {1.0, 2.0, 1.0};
  } else {
    for (std::size_t k = 0; k < legs.size(); ++k) {
      legs[k] = 0.0;
      for (int i = 0; i < request.q0.size(); ++i) {
        const double V = std::min(limits_of(request, i).speed, 1e6);
        legs[k] = std::max(legs[k], 1.5 * std::abs(points[k + 1][i] - points[k][i]) / V);
      }
    }
    const double longest = *std::ranges::max_element(legs);
    for (double& leg : legs) leg = longest > 0.0 ? std::max(leg, 0.01 * longest) : 1.0;
  }
  std::vector<double> t = {0.0};
  for (const double leg : legs) t.push_back(t.back() + leg);
  return t;
}

Trajectory lay(const Shape& shape, const std::vector<double>& t,
               const std::vector<Eigen::VectorXd>& points) {
  std::vector<JointPath> joints;
  std::vector<double> q(points.size());
  for (Eigen::Index i = 0; i < points[0].size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) q[k] = points[k][i];
    JointPath path{.q_end = q.back()};
    const bool still = std::ranges::all_of(q, [&](double value) { return value == q[0]; });
    if (!still) path.segments = shape.curve(t, q, {});
    joints.push_back(std::move(path));
  }
  return {std::move(joints), t.back()};
}

// The least time of this curve, and the limit that decides it.
TooFast slowest_joint(const MoveRequest& request, const Trajectory& motion, bool smooth) {
  TooFast slowest{.limit = limits_of(request, 0).speed};
  const auto consider = [&](int i, LimitKind kind, double stretch) {
    const double least = motion.duration() * stretch;
    if (!(least > slowest.least_time)) return;
    slowest = {.joint = i,
               .least_time = least,
               .travel = travel_of(request, i),
               .kind = kind,
               .limit = limit_value(limits_of(request, i), kind)};
  };
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& limits = limits_of(request, i);
    consider(i, LimitKind::kSpeed, motion.peak(i, 1) / limits.speed);
    consider(i, LimitKind::kAcceleration, std::sqrt(motion.peak(i, 2) / limits.acceleration));
    if (smooth) consider(i, LimitKind::kJerk, cube_root(motion.peak(i, 3) / limits.jerk));
  }
  return slowest;
}

Plan plan_shape(const MoveRequest& request, const Shape& shape) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  const std::vector<Eigen::VectorXd> points = points_of(request, shape);
  const std::vector<double> t = times_of(request, shape, points);
  const Trajectory motion = lay(shape, t, points);
  MoveRequest timed = request;
  if (!request.durations.empty()) {
    timed.time = 0.0;
    for (const double leg : request.durations) *timed.time += leg;
  }
  const Duration chosen = choose_duration(timed, slowest_joint(request, motion, shape.smooth));
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  const bool as_given = request.durations.size() == t.size() - 1;
  return {.trajectory = as_given ? motion : motion.stretched(chosen.T / motion.duration()),
          .too_fast = chosen.too_fast};
}

std::vector<Segment> spline_3(std::span<const double> t, std::span<const double> q,
                              const PathEnds& ends) {
  return cubic_spline(t, q, ends.v_start, ends.v_end);
}

}  // namespace

Plan plan_cubic_interpolator(const MoveRequest& request) {
  return plan_shape(request, {"Cubic", cubic_interpolator, false, false});
}
Plan plan_spline_3(const MoveRequest& request) {
  return plan_shape(request, {"Spline3", spline_3, false, false});
}
Plan plan_spline_4(const MoveRequest& request) {
  return plan_shape(request, {"Spline4", quartic_spline, false, true});
}
Plan plan_spline_5(const MoveRequest& request) {
  return plan_shape(request, {"Spline5", quintic_spline, false, true});
}
Plan plan_434(const MoveRequest& request) {
  return plan_shape(request, {"434", quartic_spline, true, true});
}
Plan plan_353(const MoveRequest& request) {
  return plan_shape(request, {"353", path_353, true, true});
}
Plan plan_five_cubics(const MoveRequest& request) {
  return plan_shape(request, {"FiveCubic", path_five_cubics, true, true});
}

}  // namespace armlet
