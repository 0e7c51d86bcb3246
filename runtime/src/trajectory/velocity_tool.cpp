#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "trajectory/take_up.hpp"
#include "trajectory/velocity_motion.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortestQuintic = 1e-4;  // s
// Between solved joint speeds: s while they change, and rad or m while they are held.
constexpr double kLongestStep = 5e-3;
constexpr double kFarthestStep = 2e-3;
constexpr double kLacking = 1e-6;        // of the velocity asked for
constexpr double kRankThreshold = 1e-9;  // of the largest pivot
// Parts of the limits on acceleration and jerk with which the tool takes up a velocity; the rest is
// for the joints turning under it. The first that suffices is taken.
constexpr double kShares[] = {0.9, 0.75, 0.6, 0.45, 0.3, 0.2, 0.12, 0.07};
// Of the limits, while it is decided how to take up a velocity: planned again in the middle, the
// polynomials differ a little.
constexpr double kWithin = 0.995;
// How much faster the tool may become than before, or than it is asked to.
constexpr double kCalm = 1.005;

// Joint speeds for a velocity of the tool, and what is lacking of it.
struct Rates {
  VectorXd qd;
  double lacking = 0.0;
};

using Solver = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

Solver solver_of(const Jacobian& J) {
  Solver solver;
  solver.setThreshold(kRankThreshold);
  solver.compute(J);
  return solver;
}

// A command for the tool. Its speeds are those that give the tool its velocity where the joints
// are, and an error, which dies out along a law that does not depend on where the joints are: so
// the command can be planned again from any state on the motion.
//
// The law is in joint speeds. Where that makes the tool itself too fast, because the joints turn
// far meanwhile, it is in the speeds of the tool: written as joint speeds x at the position `ref`,
// they are those which give the tool the velocity J(ref) x, and the part of x that does not move
// it.
struct ToolCommand {
  const Robot& robot;
  const VelocityStart& start;
  Vector6d twist;
  VectorXd ref{};  // empty: the law is in joint speeds
  Jacobian J_ref{};
  std::optional<Solver> at_ref{};
  TakeUp take_up{};

  void refer_to(const VectorXd& q) {
    ref = q;
    J_ref = jacobian(robot, q);
    at_ref = solver_of(J_ref);
  }

  // The joint speeds at q for the velocity `v` of the tool and the error x.
  [[nodiscard]] VectorXd speeds(const Jacobian& J, const Vector6d& v, const VectorXd& x) const {
    const Solver solver = solver_of(J);
    if (ref.size() == 0) return solver.solve(v) + x;
    VectorXd qd = solver.solve(v + J_ref * x);
    if (robot.n() > 6) {
      const VectorXd still = x - at_ref->solve(J_ref * x);
      qd += still - solver.solve(J * still);
    }
    return qd;
  }
  [[nodiscard]] VectorXd speeds(const VectorXd& q, const VectorXd& x) const {
    return speeds(jacobian(robot, q), twist, x);
  }

  [[nodiscard]] Rates at(double t, const VectorXd& q) const {
    const Jacobian J = jacobian(robot, q);
    Rates rates{.qd = speeds(J, twist, take_up.at(t).x)};
    if (const double size = twist.norm(); size > 0.0 && t >= take_up.duration())
      rates.lacking = (J * rates.qd - twist).norm() / size;
    return rates;
  }

  // The rate of change of the speeds when the joints move with qd and the error stays.
  [[nodiscard]] VectorXd bend(const VectorXd& q, const VectorXd& qd, const VectorXd& x) const {
    constexpr double kApart = 1e-6;  // s
    return (speeds(q + kApart * qd, x) - speeds(q - kApart * qd, x)) / (2.0 * kApart);
  }
  [[nodiscard]] VectorXd slope(double t, const VectorXd& q, const VectorXd& qd) const {
    const TakeUp::State error = take_up.at(t);
    return bend(q, qd, error.x) + speeds(jacobian(robot, q), Vector6d::Zero(), error.a);
  }

  // Plans how the error at the start dies out.
  void plan(double share, double turning) {
    const TakeUpLimits limits{.acceleration = share * robot.max_accel(),
                              .jerk = share * robot.max_jerk(),
                              .turn = turning * robot.max_jerk()};
    const VectorXd& q = start.q;
    const Jacobian J = jacobian(robot, q);
    const VectorXd none = VectorXd::Zero(robot.n());
    VectorXd x = start.qd - speeds(q, none);
    Eigen::MatrixXd from_ref = Eigen::MatrixXd::Identity(robot.n(), robot.n());
    if (ref.size() > 0) {
      for (Eigen::Index i = 0; i < x.size(); ++i)
        from_ref.col(i) = speeds(J, Vector6d::Zero(), VectorXd(from_ref.col(i)));
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> to_ref(from_ref);
    x = to_ref.solve(x);
    const VectorXd gain = accelerations_of(start) - bend(q, start.qd, x);
    take_up = plan_take_up(x, to_ref.solve(gain), limits);
  }
};

// Joint positions one step later and the speeds there. The first slope is known: qd.
//
// source  J. C. Butcher, Numerical Methods for Ordinary Differential Equations (2016), method of
//         order 6 in seven stages.
struct Step {
  VectorXd q;
  Rates rates;
};

Step step_on(const ToolCommand& command, double t, const VectorXd& q, const VectorXd& k1,
             double h) {
  const auto slope = [&](double c, const VectorXd& change) {
    return command.at(t + c * h, q + h * change).qd;
  };
  const VectorXd k2 = slope(1.0 / 3.0, k1 / 3.0);
  const VectorXd k3 = slope(2.0 / 3.0, k2 * (2.0 / 3.0));
  const VectorXd k4 = slope(1.0 / 3.0, (k1 + 4.0 * k2 - k3) / 12.0);
  const VectorXd k5 = slope(0.5, (-k1 + 18.0 * k2 - 3.0 * k3 - 6.0 * k4) / 16.0);
  const VectorXd k6 = slope(0.5, (9.0 * k2 - 3.0 * k3 - 6.0 * k4 + 4.0 * k5) / 8.0);
  const VectorXd k7 = slope(1.0, (9.0 * k1 - 36.0 * k2 + 63.0 * k3 + 72.0 * k4 - 64.0 * k6) / 44.0);
  const VectorXd mean = (11.0 * (k1 + k7) + 81.0 * (k3 + k4) - 32.0 * (k5 + k6)) / 120.0;
  Step next{.q = q + h * mean, .rates = {}};
  next.rates = command.at(t + h, next.q);
  return next;
}

// The times until `end` at which the motion of a command changes its kind, and `end`.
std::vector<double> knots_of(const ToolCommand& command, double end) {
  std::vector<double> knots;
  double t = 0.0;
  for (const TakeUpPiece& piece : command.take_up.pieces) {
    t += piece.duration;
    if (t < end) knots.push_back(t);
  }
  knots.push_back(end);
  return knots;
}

// One step of the motion; a joint gets a polynomial of degree 5 with the states at both ends.
void add_step(VelocityPieces& pieces, const VectorXd& q, const VectorXd& qd, const VectorXd& qdd,
              double h) {
  for (Eigen::Index i = 0; i < qdd.size(); ++i) {
    // A quintic shorter than this makes a large jerk of rounding errors.
    if (h < kShortestQuintic) {
      pieces.push(i, (qdd[i] - pieces.qdd()[i]) / h, h);
    } else {
      pieces.join(i, {.q = q[i], .v = qd[i], .a = qdd[i]}, h);
    }
  }
}

// A joint that is outside its limits, farther than at the start.
std::optional<LimitViolation> leaves_limits(const ToolCommand& command, const VectorXd& q) {
  constexpr double kSlack = 1e-9;  // rad or m
  for (int i = 0; i < command.robot.n(); ++i) {
    const double start = command.start.q[i];
    const double lower = command.robot.lower()[i], upper = command.robot.upper()[i];
    if (q[i] < std::min(lower, start) - kSlack) return LimitViolation{i, q[i], lower};
    if (q[i] > std::max(upper, start) + kSlack) return LimitViolation{i, q[i], upper};
  }
  return std::nullopt;
}

// Follows a command until `end`. Nothing, or why the joints cannot.
VelocityPlan follow(const ToolCommand& command, double end, VelocityPieces& pieces) {
  const double taken_up = command.take_up.duration();
  double begin = 0.0;
  for (const double knot : knots_of(command, end)) {
    if (knot - begin < kShortestVelocity) continue;
    while (knot - begin >= kShortestVelocity) {
      const double fast = pieces.qd().cwiseAbs().maxCoeff();
      const bool slow = begin >= taken_up && fast * kLongestStep < kFarthestStep;
      const double most = slow ? kFarthestStep / fast : kLongestStep;
      const double left = knot - begin;
      const double h = left > most ? left / std::ceil(left / most) : left;
      const Step next = step_on(command, begin, pieces.q(), pieces.qd(), h);
      if (begin >= taken_up && next.rates.lacking > kLacking)
        return {.lacking = next.rates.lacking};
      if (auto high = too_fast(command.robot, next.rates.qd)) return {.too_high = high};
      if (auto outside = leaves_limits(command, next.q)) return {.outside = outside};
      add_step(pieces, next.q, next.rates.qd, command.slope(begin + h, next.q, next.rates.qd), h);
      begin = h < left ? begin + h : knot;
    }
    begin = knot;
  }
  return {};
}

// Follows the take-up to its end, however long the command holds.
//
// fits  the joints keep to their limits on acceleration and jerk.
// calm  the tool is never much faster than the fastest of what it does at the start, what it would
//       do if the joints stopped gaining speed, and what it is asked to do.
struct Trial {
  bool fits = true;
  bool calm = true;
};

Trial try_take_up(const ToolCommand& command) {
  const Robot& robot = command.robot;
  const double end = command.take_up.duration();
  if (end < kShortestVelocity) return {};
  VelocityPieces pieces(command.start);
  static_cast<void>(follow(command, end, pieces));
  const Trajectory motion = std::move(pieces).made();
  Trial trial;
  for (int i = 0; i < robot.n(); ++i) {
    const double A = std::max(kWithin * robot.max_accel()[i], std::abs(motion.value(i, 0.0, 2)));
    trial.fits = trial.fits && motion.peak(i, 2) <= A * (1.0 + 1e-9) &&
                 motion.peak(i, 3) <= kWithin * robot.max_jerk()[i];
  }
  if (!trial.fits) return trial;
  const VectorXd qdd = accelerations_of(command.start);
  const double fading = (qdd.array().abs() / robot.max_jerk().array()).maxCoeff();
  const Jacobian J = jacobian(robot, command.start.q);
  const Vector6d now = J * command.start.qd, soon = now + J * qdd * (0.5 * fading);
  const auto largest = [&](const auto& part) {
    return std::max({part(now).norm(), part(soon).norm(), part(command.twist).norm()});
  };
  const auto v = [](const Vector6d& twist) { return Eigen::Vector3d(twist.head<3>()); };
  const auto w = [](const Vector6d& twist) { return Eigen::Vector3d(twist.tail<3>()); };
  constexpr int kSamples = 32;
  constexpr double kNothing = 1e-6;  // m/s
  constexpr double kLever = 0.25;    // m, between turning and moving
  const double most_v = largest(v), most_w = largest(w);
  const double slack = (kCalm - 1.0) * (most_v + kLever * most_w) + kNothing;
  VectorXd q(robot.n()), qd(robot.n()), gain(robot.n());
  for (int k = 1; k < kSamples && trial.calm; ++k) {
    motion.sample(end * k / kSamples, q, qd, gain);
    const Vector6d twist = jacobian(robot, q) * qd;
    trial.calm = v(twist).norm() <= most_v + slack && kLever * (w(twist).norm() - most_w) <= slack;
  }
  return trial;
}

// The whole motion of a command: take-up, hold and stop, or why the joints cannot.
VelocityPlan run_command(const ToolCommand& command) {
  VelocityPieces pieces(command.start);
  VelocityPlan plan = follow(command, command.start.during, pieces);
  if (plan.too_high || plan.outside || plan.lacking > 0.0) return plan;
  come_to_rest(command.robot, pieces);
  return checked(command.robot, std::move(pieces).made());
}

// The largest share of the limits with which the velocity can be taken up; nothing: with none. An
// acceleration that another command has left is turned with the largest share of the jerk if that
// can be, so that no speed goes further than that command would have let it.
std::optional<ToolTakeUp> largest_share(ToolCommand& command, Trial& trial) {
  for (const bool slowly : {false, true}) {
    for (const double share : kShares) {
      const double turning = slowly ? share : kShares[0];
      command.plan(share, turning);
      trial = try_take_up(command);
      if (trial.fits) return ToolTakeUp{.share = share, .turning = turning, .ref = command.ref};
    }
  }
  return std::nullopt;
}

// Decides how the velocity is taken up.
ToolTakeUp choose(ToolCommand& command) {
  constexpr double kLeast = kShares[std::size(kShares) - 1];
  Trial trial;
  const auto in_joints = largest_share(command, trial);
  if (in_joints && trial.calm) return *in_joints;
  command.refer_to(command.start.q);
  if (const auto in_tool = largest_share(command, trial)) return *in_tool;
  command.ref.resize(0);
  const ToolTakeUp left = in_joints.value_or(ToolTakeUp{.share = kLeast, .turning = kLeast});
  command.plan(left.share, left.turning);
  return left;
}

}  // namespace

VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist) {
  check_start(robot, start);
  check_finite("twist", twist);
  ToolCommand command{.robot = robot, .start = start, .twist = twist};
  command.take_up.x0 = VectorXd::Zero(robot.n());  // first of all, whether there are such speeds
  if (const Rates wanted = command.at(0.0, start.q); wanted.lacking > kLacking)
    return {.lacking = wanted.lacking};
  if (start.same) {
    const ToolTakeUp& same = *start.same;
    if (same.ref.size() > 0) {
      check_size("ref", same.ref.size(), robot.n());
      command.refer_to(same.ref);
    }
    command.plan(same.share, same.turning);
    VelocityPlan plan = run_command(command);
    plan.take_up = same;
    const bool fits = !plan.too_high || plan.too_high->kind == LimitKind::kSpeed;
    if (fits) return plan;
    command.ref.resize(0);
  }
  const ToolTakeUp chosen = choose(command);
  VelocityPlan plan = run_command(command);
  plan.take_up = chosen;
  return plan;
}

}  // namespace armlet
