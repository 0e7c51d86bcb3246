#include "armlet/trajectory/velocity.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/verify.hpp"
#include "trajectory/ramp.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortest = 1e-9;         // s
constexpr double kShortestStep = 1e-14;    // s; what is shorter changes nothing that can be seen
constexpr double kShortestQuintic = 1e-4;  // s
// Of the jerk limit; where a ramp turns, the pieces that follow it overshoot by less than its
// double.
constexpr double kSettlingShare = 0.35;
constexpr double kLongestStep = 5e-3;    // s, between solved joint speeds
constexpr double kLacking = 1e-6;        // of the velocity asked for
constexpr double kRankThreshold = 1e-9;  // of the largest pivot
constexpr double kSlack = 1e-9;          // relative

void check_start(const Robot& robot, const VelocityStart& start) {
  check_size("q", start.q.size(), robot.n());
  check_size("qd", start.qd.size(), robot.n());
  check_finite("q", start.q);
  check_finite("qd", start.qd);
  if (start.qdd.size() > 0) {
    check_size("qdd", start.qdd.size(), robot.n());
    check_finite("qdd", start.qdd);
  }
  if (std::isfinite(start.during) && start.during >= kShortest) return;
  throw ArgumentError(
      fmt::format("A velocity cannot be held for {} s; expected more than 0 s.", start.during));
}

VectorXd accelerations_of(const VelocityStart& start) {
  return start.qdd.size() > 0 ? start.qdd : VectorXd(VectorXd::Zero(start.q.size()));
}

// A motion written piece by piece, joint by joint.
class Pieces {
 public:
  explicit Pieces(const VelocityStart& start)
      : paths_(static_cast<std::size_t>(start.q.size())),
        ends_(paths_.size(), 0.0),
        q_(start.q),
        qd_(start.qd),
        qdd_(accelerations_of(start)) {}

  [[nodiscard]] const VectorXd& q() const { return q_; }
  [[nodiscard]] const VectorXd& qd() const { return qd_; }
  [[nodiscard]] const VectorXd& qdd() const { return qdd_; }

  // Constant jerk of joint i.
  void push(Eigen::Index i, double jerk, double T) {
    if (T < kShortestStep) return;
    add(i, {.duration = T, .degree = 3, .c = {q_[i], qd_[i], 0.5 * qdd_[i], jerk / 6.0}});
    const AxisState next = after({.q = q_[i], .v = qd_[i], .a = qdd_[i]}, jerk, T);
    set(i, next);
  }

  // A ramp of joint i, broken off after `longest` seconds.
  void ramp(Eigen::Index i, const Ramp& ramp, double factor, double longest) {
    push(i, factor * ramp.jerk, std::min(ramp.rise, longest));
    push(i, 0.0, std::min(ramp.hold, longest - ramp.rise));
    push(i, -factor * ramp.jerk, std::min(ramp.fall, longest - ramp.rise - ramp.hold));
  }

  // Joint i has exactly this speed, and keeps it.
  void settle(Eigen::Index i, double v) {
    qd_[i] = v;
    qdd_[i] = 0.0;
  }

  // Joint i goes to a given state.
  void join(Eigen::Index i, const AxisState& to, double T) {
    add(i, quintic_segment({.q = q_[i], .v = qd_[i], .a = qdd_[i]}, to, T));
    set(i, to);
  }

  [[nodiscard]] Trajectory made() && {
    for (Eigen::Index i = 0; i < q_.size(); ++i) paths_[static_cast<std::size_t>(i)].q_end = q_[i];
    return {std::move(paths_), *std::ranges::max_element(ends_)};
  }

 private:
  void add(Eigen::Index i, Segment piece) {
    const auto k = static_cast<std::size_t>(i);
    piece.start = ends_[k];
    ends_[k] += piece.duration;
    paths_[k].segments.push_back(piece);
  }
  void set(Eigen::Index i, const AxisState& s) {
    q_[i] = s.q;
    qd_[i] = s.v;
    qdd_[i] = s.a;
  }

  std::vector<JointPath> paths_;
  std::vector<double> ends_;
  VectorXd q_, qd_, qdd_;
};

// The change of all speeds by `change` together, as a ramp from 0 to 1.
Ramp common_ramp(const Robot& robot, const VectorXd& change) {
  const double most_a = (change.array().abs() / robot.max_accel().array()).maxCoeff();
  const double most_j = (change.array().abs() / robot.max_jerk().array()).maxCoeff();
  if (most_a <= 0.0) return {};
  return make_ramp(0.0, 0.0, 1.0, 1.0 / most_a, 1.0 / most_j);
}

// Takes up new speeds within `longest` seconds as far as they are reached by then: all joints
// together if none of them gains speed yet, otherwise each as fast as it can.
void take_up(const Robot& robot, Pieces& pieces, const VectorXd& rates, double longest) {
  const VectorXd change = rates - pieces.qd();
  const bool together = pieces.qdd().isZero(0.0);
  const Ramp common = together ? common_ramp(robot, change) : Ramp{};
  for (Eigen::Index i = 0; i < rates.size(); ++i) {
    const double limit = std::max(robot.max_accel()[i], std::abs(pieces.qdd()[i]));
    const Ramp ramp =
        together ? common
                 : make_ramp(pieces.qd()[i], pieces.qdd()[i], rates[i], limit, robot.max_jerk()[i]);
    pieces.ramp(i, ramp, together ? change[i] : 1.0, longest);
    if (ramp.duration() > longest) continue;
    pieces.settle(i, rates[i]);
    if (std::isfinite(longest)) pieces.push(i, 0.0, longest - ramp.duration());
  }
}

void come_to_rest(const Robot& robot, Pieces& pieces) {
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

// The plan for a motion that ends at rest, if it keeps to the limits.
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

// The same change, `factor` times as slow.
Ramp slowed(const Ramp& ramp, double factor) {
  return {.jerk = ramp.jerk / (factor * factor),
          .rise = ramp.rise * factor,
          .hold = ramp.hold * factor,
          .fall = ramp.fall * factor};
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

// A command for the tool while its velocity changes along `law` from 0 to 1. What the joints move
// beside the tool at the start dies out with it; what they gain beside it dies out by itself.
struct ToolCommand {
  const Robot& robot;
  const VelocityStart& start;
  Vector6d from;
  Vector6d to;
  VectorXd beside;
  VectorXd surplus;              // acceleration at the start that the tool does not ask for
  std::vector<Ramp> settling{};  // of speeds with that acceleration back to none
  Ramp law{};

  [[nodiscard]] AxisState share(double t) const { return along({}, law, t); }
  [[nodiscard]] AxisState settled(Eigen::Index i, double t) const {
    return along({.a = surplus[i]}, settling[static_cast<std::size_t>(i)], t);
  }

  [[nodiscard]] Rates at(double t, const VectorXd& q) const {
    const double s = share(t).v;
    Rates rates = solve_rates(robot, q, from + s * (to - from));
    rates.qd += (1.0 - s) * beside;
    for (Eigen::Index i = 0; i < q.size(); ++i) rates.qd[i] += settled(i, t).v;
    return rates;
  }

  // The rate of change of at(t, q) when the joints move with qd.
  [[nodiscard]] VectorXd slope(double t, const VectorXd& q, const VectorXd& qd) const {
    constexpr double kApart = 1e-6;  // s
    const AxisState s = share(t);
    const Vector6d twist = from + s.v * (to - from);
    VectorXd qdd = (solve_rates(robot, q + kApart * qd, twist).qd -
                    solve_rates(robot, q - kApart * qd, twist).qd) /
                   (2.0 * kApart);
    qdd += s.a * (solve_rates(robot, q, to - from).qd - beside);
    for (Eigen::Index i = 0; i < q.size(); ++i) qdd[i] += settled(i, t).a;
    return qdd;
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
  const Ramp& law = command.law;
  Pieces pieces(command.start);
  double begin = 0.0;
  for (const double knot : {law.rise, law.rise + law.hold, law.duration(), during}) {
    const double end = std::min(knot, during);
    if (end - begin < kShortest) continue;
    const auto steps = static_cast<int>(std::ceil((end - begin) / kLongestStep));
    const double h = (end - begin) / steps;
    for (int k = 0; k < steps; ++k) {
      const double t = begin + k * h;
      const Step next = step_on(command, t, pieces.q(), pieces.qd(), h);
      if (t >= law.duration() && next.rates.lacking > kLacking)
        return {.lacking = next.rates.lacking};
      if (auto fast = too_fast(command.robot, next.rates.qd)) return {.too_high = fast};
      const VectorXd qdd = command.slope(t + h, next.q, next.rates.qd);
      for (Eigen::Index i = 0; i < qdd.size(); ++i) {
        // A quintic shorter than this makes a large jerk of rounding errors.
        if (h < kShortestQuintic) {
          pieces.push(i, (qdd[i] - pieces.qdd()[i]) / h, h);
        } else {
          pieces.join(i, {.q = next.q[i], .v = next.rates.qd[i], .a = qdd[i]}, h);
        }
      }
    }
    begin = end;
  }
  come_to_rest(command.robot, pieces);
  return checked(command.robot, std::move(pieces).made());
}

ToolCommand tool_command(const Robot& robot, const VelocityStart& start, const Vector6d& twist) {
  ToolCommand command{
      .robot = robot, .start = start, .from = {}, .to = twist, .beside = {}, .surplus = {}};
  const auto n = static_cast<std::size_t>(robot.n());
  command.from = jacobian(robot, start.q) * start.qd;
  command.beside = start.qd - solve_rates(robot, start.q, command.from).qd;
  command.surplus = VectorXd::Zero(robot.n());
  command.settling.resize(n);
  command.surplus = accelerations_of(start) - command.slope(0.0, start.q, start.qd);
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double a = command.surplus[k];
    command.settling[i] = make_ramp(0.0, a, 0.0, std::max(robot.max_accel()[k], std::abs(a)),
                                    kSettlingShare * robot.max_jerk()[k]);
  }
  return command;
}

}  // namespace

VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const VectorXd& rates) {
  check_start(robot, start);
  check_size("rates", rates.size(), robot.n());
  check_finite("rates", rates);
  if (auto fast = too_fast(robot, rates)) return {.too_high = fast};
  Pieces pieces(start);
  take_up(robot, pieces, rates, start.during);
  come_to_rest(robot, pieces);
  return checked(robot, std::move(pieces).made());
}

VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist) {
  check_start(robot, start);
  check_finite("twist", twist);
  const Rates wanted = solve_rates(robot, start.q, twist);
  if (wanted.lacking > kLacking) return {.lacking = wanted.lacking};
  ToolCommand command = tool_command(robot, start, twist);
  const VectorXd change = wanted.qd - start.qd;
  command.law = common_ramp(robot, change);
  // The joints turn meanwhile, which may need more acceleration and jerk than the change alone.
  constexpr int kAttempts = 16;
  double slower = 1.0;
  VelocityPlan plan;
  for (int k = 0; k < kAttempts; ++k) {
    plan = run_command(command);
    if (!plan.too_high || plan.too_high->kind == LimitKind::kSpeed) break;
    const double over = plan.too_high->value / plan.too_high->limit;
    const bool jerks = plan.too_high->kind == LimitKind::kJerk;
    slower *= std::clamp(1.02 * (jerks ? std::sqrt(over) : over), 1.02, 2.0);
    command.law = slowed(common_ramp(robot, change), slower);
  }
  return plan;
}

}  // namespace armlet
