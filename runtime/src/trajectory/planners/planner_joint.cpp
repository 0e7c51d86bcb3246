// Planners that move the joints one after another, or each by itself with limited jerk.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/trajectory/jerk_limited.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

Segment standing(double q, double T) { return {.duration = T, .degree = 0, .c = {q}}; }

TooFast named(const MoveRequest& request, int joint, LimitKind kind) {
  return {.joint = joint,
          .travel = travel_of(request, joint),
          .kind = kind,
          .limit = limit_value(limits_of(request, joint), kind)};
}

// The limit that the fastest motion over the distance D holds for some time, if there is only one.
LimitKind held_limit(double D, const AxisLimits& limits) {
  const double V = limits.speed, A = limits.acceleration, J = limits.jerk;
  const double up = V * J >= A * A ? A / J + V / A : 2.0 * std::sqrt(V / J);
  if (D >= V * up) return LimitKind::kSpeed;
  return D >= 2.0 * A * A * A / (J * J) ? LimitKind::kAcceleration : LimitKind::kJerk;
}

TooFast slowest_of_limited_jerk(const MoveRequest& request, std::span<const AxisState> from,
                                std::span<const double> to) {
  int slowest = 0;
  double longest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double T = fastest_jerk_limited(from[i], to[i], request.limits[i]).duration();
    if (T > longest) slowest = static_cast<int>(i);
    longest = std::max(longest, T);
  }
  const double D = std::abs(travel_of(request, slowest));
  return named(request, slowest, held_limit(D, limits_of(request, slowest)));
}

// If more time is requested, the whole motion is slowed down. Empty if the motors cannot hold the
// arm at some position.
std::optional<Plan> plan_with_motors(const MoveRequest& request) {
  std::optional<Trajectory> fastest = limited_jerk_with_motors(request);
  if (!fastest) return {};
  const std::vector<AxisLimits> limits = limits_beside_motors(request);
  const Duration chosen =
      choose_duration(request, tightest_joint(request, limits, *fastest, Jerk::kLimited));
  if (!chosen.possible) return Plan{.too_fast = chosen.too_fast};
  return Plan{.trajectory = fastest->stretched(chosen.T / fastest->duration()),
              .too_fast = chosen.too_fast};
}

}  // namespace

Plan plan_one_by_one(const MoveRequest& request) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  std::vector<JointPath> joints;
  TooFast slowest = named(request, 0, LimitKind::kSpeed);
  double longest = 0.0;
  double T = 0.0;
  for (int i = 0; i < request.q0.size(); ++i) {
    const double D = travel_of(request, i);
    JointPath path{.q_end = request.q1[i]};
    if (D != 0.0) {
      const LeastTime least = quintic_least_time(D, limits_of(request, i));
      // A joint without limits takes one second, scaled like the other joints.
      const double share = least.time > 0.0 ? least.time : 1.0;
      if (T > 0.0) path.segments.push_back(standing(request.q0[i], T));
      path.segments.push_back(quintic_segment({.q = request.q0[i]}, {.q = request.q1[i]}, share));
      path.segments.back().start = T;
      T += share;
      const double sum = slowest.least_time + least.time;
      if (least.time > longest) slowest = named(request, i, least.limit);
      longest = std::max(longest, least.time);
      slowest.least_time = sum;
    }
    joints.push_back(std::move(path));
  }
  const Duration chosen = choose_duration(request, slowest);
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  return {.trajectory = Trajectory(std::move(joints), T).stretched(chosen.T / T),
          .too_fast = chosen.too_fast};
}

Plan plan_without_ramps(const MoveRequest& request) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  TooFast slowest = named(request, 0, LimitKind::kSpeed);
  for (int i = 0; i < request.q0.size(); ++i) {
    const double T = std::abs(travel_of(request, i)) / limits_of(request, i).speed;
    if (T <= slowest.least_time) continue;
    slowest = named(request, i, LimitKind::kSpeed);
    slowest.least_time = T;
  }
  const Duration chosen = choose_duration(request, slowest);
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  std::vector<JointPath> joints;
  for (int i = 0; i < request.q0.size(); ++i) {
    JointPath path{.q_end = request.q1[i]};
    if (const double D = travel_of(request, i); D != 0.0) {
      path.segments = {{.duration = chosen.T, .degree = 1, .c = {request.q0[i], D / chosen.T}}};
    }
    joints.push_back(std::move(path));
  }
  return {.trajectory = Trajectory(std::move(joints), chosen.T), .too_fast = chosen.too_fast};
}

Plan plan_limited_jerk(const MoveRequest& request) {
  if (stands_still(request)) {
    return {.trajectory = Trajectory::at_rest(request.q1, request.time.value_or(0.0))};
  }
  if (request.motors != nullptr) {
    if (auto plan = plan_with_motors(request)) return *std::move(plan);
  }
  PhasedMove move = phased_move(request, request.limits);
  TooFast limiting = slowest_of_limited_jerk(request, move.from, move.to);
  limiting.least_time = move.T;
  const Duration chosen = choose_duration(request, limiting);
  if (!chosen.possible) return {.too_fast = chosen.too_fast};
  const bool slower = request.time && !chosen.too_fast && chosen.T > move.T;
  if (!slower) {
    return {.trajectory = move.trajectory().stretched(chosen.T / move.T),
            .too_fast = chosen.too_fast};
  }
  // If more time is requested, the speeds are reduced; accelerations and jerks stay the same.
  move.T = chosen.T;
  for (std::size_t i = 0; i < move.to.size(); ++i) {
    const AxisLimits& limits = request.limits[i];
    const JerkProfile fastest = fastest_jerk_limited(move.from[i], move.to[i], limits);
    move.profiles[i] =
        jerk_limited_in_time(move.from[i], move.to[i], limits, move.T, fastest).value_or(fastest);
  }
  return {.trajectory = move.trajectory()};
}

PhasedMove phased_move(const MoveRequest& request, std::span<const AxisLimits> limits) {
  const std::size_t n = limits.size();
  PhasedMove move{.from = std::vector<AxisState>(n),
                  .to = std::vector<double>(n),
                  .profiles = std::vector<JerkProfile>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const int joint = static_cast<int>(i);
    move.to[i] = request.q1[joint];
    move.from[i].q = travel_of(request, joint) == 0.0 ? move.to[i] : request.q0[joint];
  }
  move.T = plan_jerk_limited(move.from, move.to, limits, move.profiles);
  return move;
}

}  // namespace armlet
