#include "trajectory/velocity/velocity_command.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortestQuintic = 1e-4;  // s
constexpr double kShortestQuartic = 1e-6;  // s
// Largest interval between joint speeds that are solved: s while they change, and rad or m while
// they are constant.
constexpr double kLongestStep = 5e-3;
constexpr double kFarthestStep = 2e-3;
// Steps are halved, down to the smallest, while speeds are more uncertain than this, rad/s or m/s.
constexpr double kSmallestStep = 1e-5;
constexpr double kDoubt = 1e-8;
constexpr double kShareOfIdle = 0.7;       // of the limits, where a singular position is crossed
constexpr double kLacking = 1e-6;          // of the commanded velocity
constexpr double kLackingRounding = 1e-9;  // m/s and rad/s: as exact as the laws
constexpr double kRankThreshold = 1e-9;    // of the largest pivot

// Joint values one step later and the speeds there. The first slope is known: qd.
//
// source  J. C. Butcher, Numerical Methods for Ordinary Differential Equations (2016), method of
//         order 6 in seven stages.
//
// doubt  change of the speeds if the joints were at the values of Simpson's rule, rad/s or m/s.
struct Step {
  VectorXd q;
  ToolRates rates;
  double doubt = 0.0;
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
  const VectorXd mean7 = (9.0 * k1 - 36.0 * k2 + 63.0 * k3 + 72.0 * k4 - 64.0 * k6) / 44.0;
  const VectorXd k7 = slope(1.0, mean7);
  const VectorXd mean = (11.0 * (k1 + k7) + 81.0 * (k3 + k4) - 32.0 * (k5 + k6)) / 120.0;
  Step next{.q = q + h * mean};
  next.rates = command.at(t + h, next.q);
  const VectorXd simpson = (k1 + 4.0 * k5 + next.rates.qd) / 6.0;
  const double apart = (mean7 - mean).norm();
  if (apart > 0.0) next.doubt = (k7 - next.rates.qd).norm() / apart * (mean - simpson).norm();
  return next;
}

// The times between two at which the motion of a command changes its form, and the second time.
std::vector<double> knots_of(const ToolCommand& command, double begin, double end) {
  std::vector<double> knots;
  double t = 0.0;
  for (const TakeUpPiece& piece : command.take_up().pieces) {
    t += piece.duration;
    if (begin < t && t < end) knots.push_back(t);
  }
  knots.push_back(end);
  return knots;
}

// One step of the motion; a joint gets a polynomial of degree 5 with the states at both ends. In a
// shorter step this would make a large jerk of the rounding errors of positions, and in the
// shortest one of those of speeds too: then a polynomial of lower degree is used.
void add_step(VelocityPieces& pieces, const VectorXd& q, const VectorXd& qd, const VectorXd& qdd,
              double h) {
  for (Eigen::Index i = 0; i < qdd.size(); ++i) {
    if (h >= kShortestQuintic) {
      pieces.join(i, {.q = q[i], .v = qd[i], .a = qdd[i]}, h);
    } else if (h >= kShortestQuartic) {
      pieces.gain(i, qd[i], qdd[i], h);
    } else {
      pieces.push(i, (qdd[i] - pieces.qdd()[i]) / h, h);
    }
  }
}

// A joint that is outside its limits, farther than at the start.
std::optional<LimitViolation> leaves_limits(const Robot& robot, const VectorXd& start,
                                            const VectorXd& q) {
  constexpr double kSlack = 1e-9;  // rad or m
  for (int i = 0; i < robot.n(); ++i) {
    const double lower = robot.lower()[i], upper = robot.upper()[i];
    if (q[i] < std::min(lower, start[i]) - kSlack) return LimitViolation{i, q[i], lower};
    if (q[i] > std::max(upper, start[i]) + kSlack) return LimitViolation{i, q[i], upper};
  }
  return std::nullopt;
}

// The direction in which the joints move the tool least, by inverse iteration (Golub, Van Loan,
// Matrix Computations, 4th ed., 2013, section 8.2.2).
Vector6d lost_direction(const Jacobian& J) {
  constexpr double kSlight = 1e-12;  // of the trace, which keeps the matrix regular
  constexpr int kIterations = 12;
  Eigen::Matrix<double, 6, 6> square = J * J.transpose();
  square.diagonal().array() += kSlight * square.trace();
  const SymmetricFactors<6> factors(square);
  Vector6d u = Vector6d::Ones();
  for (int k = 0; k < kIterations; ++k) u = factors.solve(u).normalized();
  return u;
}

bool exceeds(const Robot& robot, const VelocityPieces& pieces, const FollowLimits& limits) {
  if ((pieces.qdd().array().abs() > limits.qdd.array()).any()) return true;
  return excess_of(jacobian(robot, pieces.q()) * pieces.qd(), limits.most) > limits.calm;
}

}  // namespace

// A translation that is small beside the rotation counts as a part of it, and vice versa.
double excess_of(const Vector6d& twist, const ToolSpeeds& most) {
  constexpr double kStandingStill = 1e-6;  // m/s
  constexpr double kLever = 0.25;          // m, between rotation and translation
  constexpr double kSmall = 0.05;
  const double v = most.v, w = kLever * most.w;
  const auto excess = [=](double x, double limit, double unit) {
    return x > limit + kStandingStill
               ? (x - limit - kStandingStill) / std::max(unit, kStandingStill)
               : 0.0;
  };
  return std::max(excess(twist.head<3>().norm(), v, std::max(v, kSmall * w)),
                  excess(kLever * twist.tail<3>().norm(), w, std::max(w, kSmall * v)));
}

// The rows of the task of the joint speeds: the motion of the tool, without the direction that is
// crossed, in which the joint speeds follow the error.
Jacobian ToolCommand::rows(const Jacobian& J) const {
  Jacobian rows = J;
  for (Eigen::Index i = 0; law_.crosses && i < J.cols(); ++i)
    rows.col(i) += (idle_[i] - lost_.dot(J.col(i))) * lost_;
  return rows;
}

// The joint speeds for the velocity `v` of the tool and the error x.
VectorXd ToolCommand::speeds(const Jacobian& J_tool, const Vector6d& v, const VectorXd& x) const {
  const Jacobian J = rows(J_tool);
  const OrthogonalFactors solver(J, kRankThreshold);
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
  if (const double size = twist_.norm(); size > 0.0 && t >= take_up_.duration()) {
    const double lacking = (J * rates.qd - twist_).norm();
    if (lacking > kLackingRounding) rates.lacking = lacking / size;
  }
  return rates;
}

// The rate of change of the speeds when the joints move with qd and the error is constant:
// differences of order 4, with an interval for which rounding errors, with which the next law would
// begin, are small.
VectorXd ToolCommand::bend(const VectorXd& q, const VectorXd& qd, const VectorXd& x) const {
  constexpr double kApart = 2e-5;  // s
  const auto change = [&](double s) {
    return VectorXd(speeds(q + s * qd, x) - speeds(q - s * qd, x));
  };
  return (8.0 * change(kApart) - change(2.0 * kApart)) / (12.0 * kApart);
}

VectorXd ToolCommand::slope(double t, const VectorXd& q, const VectorXd& qd) const {
  const TakeUp::State error = take_up_.at(t);
  return bend(q, qd, error.x) + speeds(jacobian(robot_, q), Vector6d::Zero(), error.a);
}

ToolCommand::ToolCommand(const Robot& robot, const VelocityStart& from, const Vector6d& twist,
                         const ToolLaw& law)
    : robot_(robot), twist_(twist), law_(law), q_start_(from.q) {
  const VectorXd none = VectorXd::Zero(robot.n());
  if (law.ref.size() > 0) {
    J_ref_ = jacobian(robot, law.ref);
    if (law.crosses) {
      lost_ = lost_direction(J_ref_);
      idle_ = J_ref_.transpose() * lost_;
      idle_ /= idle_.norm();
      J_ref_ = rows(J_ref_);
    }
    at_ref_.emplace(J_ref_, kRankThreshold);
  }
  const TakeUpLimits limits{.acceleration = law.share * robot.max_accel(),
                            .jerk = law.share * robot.max_jerk(),
                            .change = law.turning * robot.max_jerk()};
  const Jacobian J = jacobian(robot, from.q);
  VectorXd x = from.qd - speeds(J, twist, none);
  Eigen::MatrixXd from_ref = Eigen::MatrixXd::Identity(robot.n(), robot.n());
  if (law.ref.size() > 0) {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      from_ref.col(i) = speeds(J, Vector6d::Zero(), VectorXd(from_ref.col(i)));
  }
  const SquareFactors to_ref(from_ref);
  x = to_ref.solve(x);
  const VectorXd gain = accelerations_of(from) - bend(from.q, from.qd, x);
  const VectorXd a = to_ref.solve(gain);
  if (!law.crosses) {
    take_up_ = plan_take_up(x, a, limits);
    return;
  }
  // A fast motion of the joints must not delay the motion of the tool.
  const VectorXd x_idle = idle_.dot(x) * idle_, a_idle = idle_.dot(a) * idle_;
  take_up_ = sum_of(plan_take_up(x_idle, a_idle, limits.part(kShareOfIdle)),
                    plan_take_up(x - x_idle, a - a_idle, limits.part(1.0 - kShareOfIdle)));
}

VelocityPlan ToolCommand::follow(double begin, double end, VelocityPieces& pieces,
                                 const FollowLimits* limits) const {
  const double taken_up = take_up_.duration();
  double careful = 1.0;
  for (const double knot : knots_of(*this, begin, end)) {
    while (knot - begin >= kShortestVelocity) {
      const double fast = pieces.qd().cwiseAbs().maxCoeff();
      const bool held = begin >= taken_up && fast * kLongestStep < kFarthestStep;
      const double step = careful * (held ? kFarthestStep / fast : kLongestStep);
      const double left = knot - begin;
      const double h = left > step ? left / std::ceil(left / step) : left;
      const Step next = step_on(*this, begin, pieces.q(), pieces.qd(), h);
      if (limits == nullptr && next.doubt > kDoubt && h > kSmallestStep) {
        careful *= 0.5 * h / step;
        continue;
      }
      if (next.doubt < kDoubt / 64.0) careful = std::min(2.0 * careful, 1.0);
      if (begin >= taken_up && next.rates.lacking > kLacking)
        return {.lacking = next.rates.lacking};
      if (auto high = too_fast(robot_, next.rates.qd)) return {.too_high = high};
      if (auto outside = leaves_limits(robot_, q_start_, next.q)) return {.outside = outside};
      add_step(pieces, next.q, next.rates.qd, slope(begin + h, next.q, next.rates.qd), h);
      if (limits != nullptr && exceeds(robot_, pieces, *limits)) return {};
      begin = h < left ? begin + h : knot;
    }
  }
  return {};
}

}  // namespace armlet
