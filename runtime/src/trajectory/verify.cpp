#include "armlet/trajectory/verify.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "trajectory/cube_root.hpp"

namespace armlet {
namespace {

constexpr double kPositionSlack = 1e-9;  // rad or m: rounding of a polynomial that ends on a limit
constexpr double kTimeSlack = 1e-9;      // relative: rounding of a time computed from the limits

// The joints that are farther outside of their limits than at the start.
std::vector<LimitViolation> joints_outside(const Robot& robot, const Trajectory& trajectory) {
  std::vector<LimitViolation> outside;
  for (int i = 0; i < robot.n(); ++i) {
    const double q0 = trajectory.value(i, 0.0);
    const Trajectory::Range range = trajectory.range(i);
    if (range.upper > std::max(robot.upper()[i], q0) + kPositionSlack) {
      outside.push_back({.joint = i, .value = range.upper, .limit = robot.upper()[i]});
    } else if (range.lower < std::min(robot.lower()[i], q0) - kPositionSlack) {
      outside.push_back({.joint = i, .value = range.lower, .limit = robot.lower()[i]});
    }
  }
  return outside;
}

}  // namespace

std::vector<AxisLimits> axis_limits(const Robot& robot) {
  std::vector<AxisLimits> limits;
  for (int i = 0; i < robot.n(); ++i) {
    limits.push_back({.speed = robot.max_speed()[i],
                      .acceleration = robot.max_accel()[i],
                      .jerk = robot.max_jerk()[i]});
  }
  return limits;
}

TooFast least_time(const Robot& robot, const Trajectory& trajectory, Jerk jerk,
                   const Robot* motors) {
  check_size("trajectory", trajectory.n(), robot.n());
  const double T = trajectory.duration();
  TooFast slowest{.given = T, .limit = robot.max_speed()[0]};
  const auto consider = [&](int i, LimitKind kind, double load, double limit) {
    if (T * load <= slowest.least_time) return;
    slowest = {.joint = i,
               .given = T,
               .least_time = T * load,
               .travel = trajectory.end()[i] - trajectory.start()[i],
               .kind = kind,
               .limit = limit};
  };
  for (int i = 0; i < robot.n(); ++i) {
    const double V = robot.max_speed()[i];
    const double A = robot.max_accel()[i];
    consider(i, LimitKind::kSpeed, trajectory.peak(i, 1) / V, V);
    const bool by_motor = motors != nullptr && std::isfinite(motors->joint(i).max_effort);
    if (!by_motor) consider(i, LimitKind::kAcceleration, std::sqrt(trajectory.peak(i, 2) / A), A);
    if (jerk == Jerk::kFree) continue;
    const double J = robot.max_jerk()[i];
    consider(i, LimitKind::kJerk, cube_root(trajectory.peak(i, 3) / J), J);
  }
  return slowest;
}

MotionPlan verify(const Robot& robot, Trajectory trajectory, bool enforce_limits, Jerk jerk,
                  const Robot* motors) {
  check_size("trajectory", trajectory.n(), robot.n());
  MotionPlan plan;
  plan.outside = joints_outside(robot, trajectory);
  const TooFast slowest = least_time(robot, trajectory, jerk, motors);
  if (slowest.given < slowest.least_time * (1.0 - kTimeSlack)) plan.too_fast = slowest;
  if (plan.outside.empty() && !(plan.too_fast && enforce_limits)) {
    plan.trajectory = std::move(trajectory);
  }
  return plan;
}

}  // namespace armlet
