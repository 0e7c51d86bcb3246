#include "armlet/trajectory/law_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/spline.hpp"
#include "trajectory/cube_root.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

void check_ends(double first, double last) {
  constexpr double kEndTolerance = 1e-9;
  if (std::abs(first) <= kEndTolerance && std::abs(last - 1.0) <= kEndTolerance) return;
  throw ArgumentError(
      fmt::format("A law leads from 0 to 1; this one leads from {} to {}.", first, last));
}

// The pieces of one joint: the law, scaled to the distance `travel` and the time T.
JointPath path_along(const ScalarLaw& law, double q0, double travel, double T) {
  JointPath path{.q_end = q0 + travel};
  for (Segment piece : law) {
    double scale = travel;
    for (double& c : piece.c) {
      c *= scale;
      scale /= T;
    }
    piece.c[0] += q0;
    piece.start *= T;
    piece.duration *= T;
    path.segments.push_back(piece);
  }
  return path;
}

// The peaks of the derivatives of a law.
struct Peaks {
  double speed, acceleration;
  double jerk;  // 0 if the acceleration jumps, so that jerk does not limit the duration
};

// The joint that needs the longest time for a law with these peaks, and the limit that decides it.
TooFast slowest_joint(const MoveRequest& request, const Peaks& peaks) {
  TooFast slowest{.limit = limits_of(request, 0).speed};
  const auto consider = [&](int i, LimitKind kind, double least, double limit) {
    if (least <= slowest.least_time) return;
    slowest = {.joint = i,
               .given = 0.0,
               .least_time = least,
               .travel = travel_of(request, i),
               .kind = kind,
               .limit = limit};
  };
  for (int i = 0; i < request.q0.size(); ++i) {
    const double D = std::abs(travel_of(request, i));
    const AxisLimits& limits = limits_of(request, i);
    consider(i, LimitKind::kSpeed, peaks.speed * D / limits.speed, limits.speed);
    consider(i, LimitKind::kAcceleration, std::sqrt(peaks.acceleration * D / limits.acceleration),
             limits.acceleration);
    consider(i, LimitKind::kJerk, cube_root(peaks.jerk * D / limits.jerk), limits.jerk);
  }
  return slowest;
}

Plan plan_along(const ScalarLaw& law, const Peaks& peaks, const MoveRequest& request) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  const Duration chosen = choose_duration(request, slowest_joint(request, peaks));
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  std::vector<JointPath> joints;
  for (int i = 0; i < request.q0.size(); ++i) {
    const double travel = travel_of(request, i);
    joints.push_back(travel == 0.0 ? JointPath{.segments = {}, .q_end = request.q1[i]}
                                   : path_along(law, request.q0[i], travel, chosen.T));
    joints.back().q_end = request.q1[i];
  }
  return {.trajectory = Trajectory(std::move(joints), chosen.T), .too_fast = chosen.too_fast};
}

}  // namespace

ScalarLaw law_of_polynomial(std::span<const double> c) {
  constexpr std::size_t kMost = Segment::kMaxDegree + 1;
  if (c.empty() || c.size() > kMost) {
    throw ArgumentError(
        fmt::format("A law has 1 to {} coefficients; {} were given.", kMost, c.size()));
  }
  Segment piece{.duration = 1.0, .degree = static_cast<int>(c.size()) - 1};
  std::ranges::copy(c, piece.c.begin());
  check_ends(piece.value(0.0), piece.value(1.0));
  return {piece};
}

ScalarLaw law_of_values(std::span<const double> s) {
  const std::size_t n = s.size();
  if (n < 6) throw ArgumentError(fmt::format("A law needs six values; {} were given.", n));
  for (const double value : s) check_finite("a value of the law", value);
  check_ends(s.front(), s.back());
  const double h = 1.0 / static_cast<double>(n - 1);
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) x[k] = k + 1 == n ? 1.0 : static_cast<double>(k) * h;
  // The derivative at the end of the quintic through six values; a value as small as rounding
  // errors counts as zero.
  constexpr double kRest = 1e-4;
  const auto slope = [&](std::size_t end, int step) {
    static constexpr double kWeights[] = {-137.0 / 60.0, 5.0, -5.0, 10.0 / 3.0, -1.25, 0.2};
    double sum = 0.0;
    for (int k = 0; k < 6; ++k) sum += kWeights[k] * s[end + static_cast<std::size_t>(step * k)];
    return std::abs(sum) < kRest * h ? 0.0 : step * sum / h;
  };
  return cubic_spline(x, s, slope(0, 1), slope(n - 1, -1));
}

Planner planner_of_law(ScalarLaw law) {
  const Trajectory unit({JointPath{.segments = law, .q_end = 1.0}}, 1.0);
  // The largest jump of the acceleration, as a fraction of the highest one, that may be an error of
  // interpolation.
  constexpr double kJump = 0.02;
  const bool is_smooth = unit.continuity(0, kJump) >= 2;
  const Peaks peaks{unit.peak(0, 1), unit.peak(0, 2), is_smooth ? unit.peak(0, 3) : 0.0};
  return [law = std::move(law), peaks](const MoveRequest& request) {
    return plan_along(law, peaks, request);
  };
}

}  // namespace armlet
