#include "trajectory/velocity_command.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortestQuintic = 1e-4;  // s
// Between solved joint speeds: s while they change, and rad or m while they are held.
constexpr double kLongestStep = 5e-3;
constexpr double kFarthestStep = 2e-3;
constexpr double kLacking = 1e-6;        // of the velocity asked for
constexpr double kRankThreshold = 1e-9;  // of the largest pivot

// Joint positions one step later and the speeds there. The first slope is known: qd.
//
// source  J. C. Butcher, Numerical Methods for Ordinary Differential Equations (2016), method of
//         order 6 in seven stages.
struct Step {
  VectorXd q;
  ToolRates rates;
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
  for (const TakeUpPiece& piece : command.take_up().pieces) {
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
  for (int i = 0; i < command.robot().n(); ++i) {
    const double start = command.start().q[i];
    const double lower = command.robot().lower()[i], upper = command.robot().upper()[i];
    if (q[i] < std::min(lower, start) - kSlack) return LimitViolation{i, q[i], lower};
    if (q[i] > std::max(upper, start) + kSlack) return LimitViolation{i, q[i], upper};
  }
  return std::nullopt;
}

}  // namespace

ToolCommand::Solver ToolCommand::solver_of(const Jacobian& J) {
  Solver solver;
  solver.setThreshold(kRankThreshold);
  solver.compute(J);
  return solver;
}

void ToolCommand::refer_to(const VectorXd& q) {
  J_ref_ = jacobian(robot_, q);
  at_ref_ = solver_of(J_ref_);
}

// The joint speeds for the velocity `v` of the tool and the error x.
VectorXd ToolCommand::speeds(const Jacobian& J, const Vector6d& v, const VectorXd& x) const {
  const Solver solver = solver_of(J);
  if (law_.ref.size() == 0) return solver.solve(v) + x;
  VectorXd qd = solver.solve(v + J_ref_ * x);
  if (robot_.n() > 6) {
    const VectorXd still = x - at_ref_->solve(J_ref_ * x);
    qd += still - solver.solve(J * still);
  }
  return qd;
}

VectorXd ToolCommand::speeds(const VectorXd& q, const VectorXd& x) const {
  return speeds(jacobian(robot_, q), twist_, x);
}

ToolRates ToolCommand::at(double t, const VectorXd& q) const {
  const Jacobian J = jacobian(robot_, q);
  ToolRates rates{.qd = speeds(J, twist_, take_up_.at(t).x)};
  if (const double size = twist_.norm(); size > 0.0 && t >= take_up_.duration())
    rates.lacking = (J * rates.qd - twist_).norm() / size;
  return rates;
}

// The rate of change of the speeds when the joints move with qd and the error stays.
VectorXd ToolCommand::bend(const VectorXd& q, const VectorXd& qd, const VectorXd& x) const {
  constexpr double kApart = 1e-6;  // s
  return (speeds(q + kApart * qd, x) - speeds(q - kApart * qd, x)) / (2.0 * kApart);
}

VectorXd ToolCommand::slope(double t, const VectorXd& q, const VectorXd& qd) const {
  const TakeUp::State error = take_up_.at(t);
  return bend(q, qd, error.x) + speeds(jacobian(robot_, q), Vector6d::Zero(), error.a);
}

void ToolCommand::plan(const ToolLaw& law) {
  law_ = law;
  if (law.ref.size() > 0) refer_to(law.ref);
  const TakeUpLimits limits{.acceleration = law.share * robot_.max_accel(),
                            .jerk = law.share * robot_.max_jerk(),
                            .turn = law.turning * robot_.max_jerk()};
  const VectorXd& q = start_.q;
  const Jacobian J = jacobian(robot_, q);
  const VectorXd none = VectorXd::Zero(robot_.n());
  VectorXd x = start_.qd - speeds(q, none);
  Eigen::MatrixXd from_ref = Eigen::MatrixXd::Identity(robot_.n(), robot_.n());
  if (law.ref.size() > 0) {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      from_ref.col(i) = speeds(J, Vector6d::Zero(), VectorXd(from_ref.col(i)));
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> to_ref(from_ref);
  x = to_ref.solve(x);
  const VectorXd gain = accelerations_of(start_) - bend(q, start_.qd, x);
  take_up_ = plan_take_up(x, to_ref.solve(gain), limits);
}

VelocityPlan ToolCommand::follow(double end, VelocityPieces& pieces,
                                 const VectorXd* most_qdd) const {
  const double taken_up = take_up_.duration();
  double begin = 0.0;
  for (const double knot : knots_of(*this, end)) {
    if (knot - begin < kShortestVelocity) continue;
    while (knot - begin >= kShortestVelocity) {
      const double fast = pieces.qd().cwiseAbs().maxCoeff();
      const bool slow = begin >= taken_up && fast * kLongestStep < kFarthestStep;
      const double most = slow ? kFarthestStep / fast : kLongestStep;
      const double left = knot - begin;
      const double h = left > most ? left / std::ceil(left / most) : left;
      const Step next = step_on(*this, begin, pieces.q(), pieces.qd(), h);
      if (begin >= taken_up && next.rates.lacking > kLacking)
        return {.lacking = next.rates.lacking};
      if (auto high = too_fast(robot_, next.rates.qd)) return {.too_high = high};
      if (auto outside = leaves_limits(*this, next.q)) return {.outside = outside};
      add_step(pieces, next.q, next.rates.qd, slope(begin + h, next.q, next.rates.qd), h);
      if (most_qdd != nullptr && (pieces.qdd().cwiseAbs().array() > most_qdd->array()).any())
        return {};
      begin = h < left ? begin + h : knot;
    }
    begin = knot;
  }
  return {};
}

}  // namespace armlet
