#include "armlet/trajectory/velocity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/trajectory/verify.hpp"
#include "trajectory/planners/ramp.hpp"
#include "trajectory/velocity/take_up.hpp"
#include "trajectory/velocity/velocity_motion.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kSlack = 1e-9;  // relative

// The largest |speed| of joint i while the error of its speed, relative to a target, decays.
double fastest_of(const TakeUp& take_up, Eigen::Index i, double target) {
  AxisState s{.v = take_up.x0[i] + target, .a = take_up.a0[i]};
  double fastest = std::abs(s.v);
  for (const TakeUpPiece& piece : take_up.pieces) {
    const double turns = -s.a / piece.jerk[i];
    if (turns > 0.0 && turns < piece.duration)
      fastest = std::max(fastest, std::abs(after(s, piece.jerk[i], turns).v));
    s = after(s, piece.jerk[i], piece.duration);
    fastest = std::max(fastest, std::abs(s.v));
  }
  return fastest;
}

bool keeps_speed_limits(const Robot& robot, const TakeUp& take_up, const VectorXd& rates) {
  for (Eigen::Index i = 0; i < rates.size(); ++i) {
    if (fastest_of(take_up, i, rates[i]) > robot.max_speed()[i] * (1.0 + 0.5 * kSlack))
      return false;
  }
  return true;
}

// Every joint reaches its speed as fast as it can, independently of the others. So every joint that
// can be stopped within its speed limit is.
void take_up_alone(const Robot& robot, VelocityPieces& pieces, const VectorXd& rates,
                   double longest) {
  for (Eigen::Index i = 0; i < rates.size(); ++i) {
    const double limit = std::max(robot.max_accel()[i], std::abs(pieces.qdd()[i]));
    const Ramp ramp =
        make_ramp(pieces.qd()[i], pieces.qdd()[i], rates[i], limit, robot.max_jerk()[i]);
    pieces.ramp(i, ramp, longest);
    if (ramp.duration() > longest) continue;
    pieces.settle(i, rates[i]);
    if (std::isfinite(longest)) pieces.push(i, 0.0, longest - ramp.duration());
  }
}

// Takes up new speeds for at most `longest` seconds, as far as they are reached by then.
void take_up(const Robot& robot, VelocityPieces& pieces, const VectorXd& rates, double longest) {
  const TakeUpLimits limits{
      .acceleration = robot.max_accel(), .jerk = robot.max_jerk(), .change = robot.max_jerk()};
  const TakeUp together = plan_take_up(pieces.qd() - rates, pieces.qdd(), limits);
  if (!keeps_speed_limits(robot, together, rates))
    return take_up_alone(robot, pieces, rates, longest);
  double left = longest;
  for (const TakeUpPiece& piece : together.pieces) {
    const double T = std::min(piece.duration, left);
    for (Eigen::Index i = 0; i < rates.size(); ++i) pieces.push(i, piece.jerk[i], T);
    left -= T;
    if (left <= 0.0) return;
  }
  for (Eigen::Index i = 0; i < rates.size(); ++i) {
    pieces.settle(i, rates[i]);
    if (std::isfinite(longest)) pieces.push(i, 0.0, left);
  }
}

}  // namespace

void check_start(const Robot& robot, const VelocityStart& start) {
  check_size("q", start.q.size(), robot.n());
  check_size("qd", start.qd.size(), robot.n());
  check_finite("q", start.q);
  check_finite("qd", start.qd);
  if (start.qdd.size() > 0) {
    check_size("qdd", start.qdd.size(), robot.n());
    check_finite("qdd", start.qdd);
  }
  if (std::isfinite(start.during) && start.during >= kShortestVelocity) return;
  throw ArgumentError(
      fmt::format("A velocity cannot be held for {} s; expected more than 0 s.", start.during));
}

VectorXd accelerations_of(const VelocityStart& start) {
  return start.qdd.size() > 0 ? start.qdd : VectorXd(VectorXd::Zero(start.q.size()));
}

void come_to_rest(const Robot& robot, VelocityPieces& pieces) {
  take_up(robot, pieces, VectorXd::Zero(pieces.q().size()),
          std::numeric_limits<double>::infinity());
}

std::optional<RateTooHigh> too_fast(const Robot& robot, const VectorXd& rates) {
  for (int i = 0; i < robot.n(); ++i) {
    const double limit = robot.max_speed()[i];
    if (std::abs(rates[i]) > limit * (1.0 + kSlack))
      return RateTooHigh{i, LimitKind::kSpeed, std::abs(rates[i]), limit};
  }
  return std::nullopt;
}

// The plan for a motion that ends at rest, if it keeps the limits.
VelocityPlan checked(const Robot& robot, Trajectory motion) {
  MotionPlan plan = verify(robot, std::move(motion));
  if (!plan.outside.empty()) return {.outside = plan.outside.front()};
  if (plan.too_fast) {
    const TooFast& fast = *plan.too_fast;
    const double load = fast.least_time / fast.given;
    const double value = fast.limit * (fast.kind == LimitKind::kSpeed ? load : load * load);
    return {.too_high = RateTooHigh{fast.joint, fast.kind, value, fast.limit}};
  }
  for (int i = 0; i < robot.n(); ++i) {
    const double jerk = plan.trajectory->peak(i, 3), limit = robot.max_jerk()[i];
    if (jerk > limit * (1.0 + kSlack))
      return {.too_high = RateTooHigh{i, LimitKind::kJerk, jerk, limit}};
  }
  return {.motion = std::move(plan.trajectory)};
}

VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const VectorXd& rates) {
  check_start(robot, start);
  check_size("rates", rates.size(), robot.n());
  check_finite("rates", rates);
  if (auto fast = too_fast(robot, rates)) return {.too_high = fast};
  VelocityPieces pieces(start);
  take_up(robot, pieces, rates, start.during);
  come_to_rest(robot, pieces);
  return checked(robot, std::move(pieces).made());
}

}  // namespace armlet
