#include "armlet/trajectory/velocity.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortest = 1e-9;       // s
constexpr double kLongestStep = 5e-3;    // s, between solved joint speeds
constexpr double kLacking = 1e-6;        // of the velocity asked for
constexpr double kRankThreshold = 1e-9;  // of the largest pivot
constexpr double kSlack = 1e-9;          // relative

void check_start(const Robot& robot, const VelocityStart& start) {
  check_size("q", start.q.size(), robot.n());
  check_size("qd", start.qd.size(), robot.n());
  check_finite("q", start.q);
  check_finite("qd", start.qd);
  if (std::isfinite(start.during) && start.during >= kShortest) return;
  throw ArgumentError(
      fmt::format("A velocity cannot be held for {} s; expected more than 0 s.", start.during));
}

// A motion written piece by piece, all joints together.
class Pieces {
 public:
  explicit Pieces(const VectorXd& q) : paths_(static_cast<std::size_t>(q.size())), q_(q) {}

  [[nodiscard]] const VectorXd& q() const { return q_; }
  [[nodiscard]] double end() const { return t_; }

  // The speeds change evenly from v0 to v1.
  void ramp(const VectorXd& v0, const VectorXd& v1, double T) {
    if (T < kShortest) return;
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      const double half_a = 0.5 * (v1[i] - v0[i]) / T;
      add(i, {.start = t_, .duration = T, .degree = 2, .c = {q_[i], v0[i], half_a}});
    }
    finish(q_ + 0.5 * T * (v0 + v1), T);
  }

  // To given positions, with given speeds at both ends.
  void join(const VectorXd& v0, const VectorXd& q1, const VectorXd& v1, double T) {
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      Segment piece = cubic_segment({.q = q_[i], .v = v0[i]}, {.q = q1[i], .v = v1[i]}, T);
      piece.start = t_;
      add(i, piece);
    }
    finish(q1, T);
  }

  [[nodiscard]] Trajectory made() && {
    for (Eigen::Index i = 0; i < q_.size(); ++i) paths_[static_cast<std::size_t>(i)].q_end = q_[i];
    return {std::move(paths_), t_};
  }

 private:
  void add(Eigen::Index i, const Segment& piece) {
    paths_[static_cast<std::size_t>(i)].segments.push_back(piece);
  }
  void finish(const VectorXd& q, double T) {
    q_ = q;
    t_ += T;
  }

  std::vector<JointPath> paths_;
  VectorXd q_;
  double t_ = 0.0;
};

// How long a change of all speeds takes at least.
double ramp_time(const Robot& robot, const VectorXd& change) {
  return (change.array().abs() / robot.max_accel().array()).maxCoeff();
}

std::optional<RateTooHigh> too_fast(const Robot& robot, const VectorXd& rates) {
  for (int i = 0; i < robot.n(); ++i) {
    const double limit = robot.max_speed()[i];
    if (std::abs(rates[i]) > limit * (1.0 + kSlack))
      return RateTooHigh{i, LimitKind::kSpeed, std::abs(rates[i]), limit};
  }
  return std::nullopt;
}

// The plan for a motion that ends at rest, if it keeps to the limits.
VelocityPlan checked(const Robot& robot, Trajectory motion) {
  MotionPlan plan = verify(robot, std::move(motion));
  if (!plan.outside.empty()) return {.outside = plan.outside.front()};
  if (plan.trajectory) return {.motion = std::move(plan.trajectory)};
  const TooFast& fast = *plan.too_fast;
  const double load = fast.least_time / fast.given;
  const double value = fast.limit * (fast.kind == LimitKind::kSpeed ? load : load * load);
  return {.too_high = RateTooHigh{fast.joint, fast.kind, value, fast.limit}};
}

// Joint speeds for a velocity of the tool, and what is lacking of it.
struct Rates {
  VectorXd qd;
  double lacking;
};

Rates solve_rates(const Robot& robot, const VectorXd& q, const Vector6d& twist) {
  const Jacobian J = jacobian(robot, q);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kRankThreshold);
  solver.compute(J);
  VectorXd qd = solver.solve(twist);
  const double size = twist.norm();
  const double lacking = size > 0.0 ? (J * qd - twist).norm() / size : 0.0;
  return {std::move(qd), lacking};
}

// A command for the tool while its velocity changes evenly for `ramp` seconds. What the joints move
// beside the tool at the start dies out with it.
struct ToolCommand {
  const Robot& robot;
  const VelocityStart& start;
  Vector6d from;
  Vector6d to;
  VectorXd beside;
  double ramp = 0.0;

  [[nodiscard]] Rates at(double t, const VectorXd& q) const {
    const double s = ramp > 0.0 ? std::min(t / ramp, 1.0) : 1.0;
    Rates rates = solve_rates(robot, q, from + s * (to - from));
    rates.qd += (1.0 - s) * beside;
    return rates;
  }
};

// Joint positions one step later (Kutta's classic four slopes) and the speeds there.
struct Step {
  VectorXd q;
  Rates rates;
};

Step step_on(const ToolCommand& command, double t, const VectorXd& q, const VectorXd& qd,
             double h) {
  const VectorXd k2 = command.at(t + 0.5 * h, q + 0.5 * h * qd).qd;
  const VectorXd k3 = command.at(t + 0.5 * h, q + 0.5 * h * k2).qd;
  const VectorXd k4 = command.at(t + h, q + h * k3).qd;
  Step next{.q = q + (h / 6.0) * (qd + 2.0 * k2 + 2.0 * k3 + k4), .rates = {}};
  next.rates = command.at(t + h, next.q);
  return next;
}

// The whole motion of a command: ramp, hold and stop, or what is lacking on the way.
VelocityPlan run_command(const ToolCommand& command) {
  const double during = command.start.during;
  const double ramp = std::min(command.ramp, during);
  Pieces pieces(command.start.q);
  VectorXd qd = command.start.qd;
  for (const auto& [begin, end] : {std::pair(0.0, ramp), std::pair(ramp, during)}) {
    if (end - begin < kShortest) continue;
    const auto steps = static_cast<int>(std::ceil((end - begin) / kLongestStep));
    const double h = (end - begin) / steps;
    for (int k = 0; k < steps; ++k) {
      const Step next = step_on(command, begin + k * h, pieces.q(), qd, h);
      if (begin >= ramp && next.rates.lacking > kLacking) return {.lacking = next.rates.lacking};
      if (auto fast = too_fast(command.robot, next.rates.qd)) return {.too_high = fast};
      pieces.join(qd, next.q, next.rates.qd, h);
      qd = next.rates.qd;
    }
  }
  pieces.ramp(qd, VectorXd::Zero(qd.size()), ramp_time(command.robot, qd));
  return checked(command.robot, std::move(pieces).made());
}

}  // namespace

VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const VectorXd& rates) {
  check_start(robot, start);
  check_size("rates", rates.size(), robot.n());
  check_finite("rates", rates);
  if (auto fast = too_fast(robot, rates)) return {.too_high = fast};
  const double whole = ramp_time(robot, rates - start.qd);
  const double ramp = std::min(whole, start.during);
  const VectorXd held =
      whole > ramp ? VectorXd(start.qd + (ramp / whole) * (rates - start.qd)) : rates;
  Pieces pieces(start.q);
  pieces.ramp(start.qd, held, ramp);
  pieces.ramp(held, held, start.during - pieces.end());
  pieces.ramp(held, VectorXd::Zero(held.size()), ramp_time(robot, held));
  return checked(robot, std::move(pieces).made());
}

VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist) {
  check_start(robot, start);
  check_finite("twist", twist);
  const Rates wanted = solve_rates(robot, start.q, twist);
  if (wanted.lacking > kLacking) return {.lacking = wanted.lacking};
  ToolCommand command{.robot = robot, .start = start, .from = {}, .to = twist, .beside = {}};
  command.from = jacobian(robot, start.q) * start.qd;
  command.beside = start.qd - solve_rates(robot, start.q, command.from).qd;
  command.ramp = ramp_time(robot, wanted.qd - start.qd);
  // The joints turn meanwhile, which may need more acceleration than the change alone.
  constexpr int kAttempts = 12;
  VelocityPlan plan;
  for (int k = 0; k < kAttempts; ++k) {
    plan = run_command(command);
    if (!plan.too_high || plan.too_high->kind != LimitKind::kAcceleration) break;
    command.ramp = std::max(command.ramp, kShortest) *
                   std::clamp(1.02 * plan.too_high->value / plan.too_high->limit, 1.02, 2.0);
  }
  return plan;
}

}  // namespace armlet
