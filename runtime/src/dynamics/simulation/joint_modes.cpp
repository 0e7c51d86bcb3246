#include "joint_modes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/math/det_math.hpp"
#include "dynamics/trees/follower_forces.hpp"

namespace armlet {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

bool JointModes::is_composed() const {
  return has_followers(*robot_) || robot_->coupling() != nullptr;
}

bool JointModes::has_dry_friction(Eigen::Index i) const {
  const PlanFriction& friction = motor(i).friction;
  return friction.coulomb_plus != 0.0 || friction.coulomb_minus != 0.0 ||
         friction.stribeck_rate != 0.0;
}

double JointModes::friction(Eigen::Index i, double qd) const {
  const PlanFriction& friction = motor(i).friction;
  const int slides = (*this)[i].slides;
  double force = friction.viscous * qd;
  if (slides == 0) return force;
  force += slides > 0 ? friction.coulomb_plus : friction.coulomb_minus;
  if (friction.stribeck_rate == 0.0) return force;
  const double ratio = qd * friction.stribeck_rate;
  return force + (slides > 0 ? friction.static_extra_plus : friction.static_extra_minus) *
                     det::exp(-ratio * ratio);
}

JointModes::Range JointModes::range_of(Eigen::Index i) const {
  const PlanFriction& friction = motor(i).friction;
  const int at_stop = (*this)[i].at_stop;
  return {at_stop < 0 ? -kInfinity : friction.coulomb_minus + friction.static_extra_minus,
          at_stop > 0 ? kInfinity : friction.coulomb_plus + friction.static_extra_plus};
}

bool JointModes::accelerate(const double* q, const double* qd, const double* tau, double* qdd) {
  if (any_stands_ || is_composed()) return accelerate_held(q, qd, tau, qdd);
  const Eigen::Index n = robot_->n();
  const DynamicsInput in = input_of(*robot_, q, qd);
  if (in.plan.friction == FrictionKind::kNone) {
    std::copy_n(tau, n, qdd);
  } else {
    for (Eigen::Index i = 0; i < n; ++i) qdd[i] = tau[i] - friction(i, qd[i]);
  }
  bad_joint_ = kernel_for(kForwardKernels, in.plan)(in, qdd);
  return bad_joint_ == n;
}

// Solves the rows of M x = b of the moving joints for their elements of x; the other elements are
// given. False: joint bad_joint() moves no inertia.
template <class Moves>
bool JointModes::solve_part(const JointMatrix& M, const Moves& moves, const JointVector& b,
                            JointVector& x) {
  std::array<Eigen::Index, kMaxJoints> free{};
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!moves(i)) continue;
    free[static_cast<std::size_t>(count++)] = i;
    x[i] = 0.0;
  }
  if (count == 0) return true;
  const auto joint = [&](Eigen::Index k) { return free[static_cast<std::size_t>(k)]; };
  JointMatrix part(count, count);
  JointVector rest(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    rest[r] = b[joint(r)] - M.row(joint(r)).dot(x);
    for (Eigen::Index c = 0; c < count; ++c) part(r, c) = M(joint(r), joint(c));
  }
  const Eigen::LLT<JointMatrix> factors(part);
  if (factors.info() != Eigen::Success) {
    Eigen::Index least = 0;
    part.diagonal().minCoeff(&least);
    bad_joint_ = static_cast<int>(joint(least));
    return false;
  }
  factors.solveInPlace(rest);
  for (Eigen::Index r = 0; r < count; ++r) x[joint(r)] = rest[r];
  return true;
}

bool JointModes::accelerate_held(const double* q, const double* qd, const double* tau,
                                 double* qdd) {
  const Eigen::Index n = robot_->n();
  JointMatrix M(n, n);
  JointVector b(n), accel = JointVector::Zero(n);
  if (is_composed()) {
    const Eigen::Map<const Eigen::VectorXd> position(q, n), rate(qd, n);
    M = mass_matrix(*robot_, position);
    b = bias_forces(*robot_, position, rate);
    if (has_followers(*robot_)) add_follower_friction(*robot_, rate, b);
  } else {
    const DynamicsInput in = input_of(*robot_, q, qd);
    kernel_for(kMassKernels, in.plan)(in, M.data());
    kernel_for(kBiasKernels, in.plan)(in, b.data());
  }
  for (Eigen::Index i = 0; i < n; ++i)
    b[i] = tau[i] - b[i] - ((*this)[i].stands ? 0.0 : friction(i, qd[i]));
  if (!solve_part(
          M, [&](Eigen::Index i) { return !(*this)[i].stands; }, b, accel))
    return false;
  hold_ = b - M * accel;
  Eigen::Map<Eigen::VectorXd>(qdd, n) = accel;
  return true;
}

double JointModes::margin_of(Eigen::Index i, const double* q, const double* qd) const {
  const Mode& mode = (*this)[i];
  if (mode.stands) {
    const Range range = range_of(i);
    return std::min(range.highest - hold_[i], hold_[i] - range.lowest);
  }
  // By rounding, a joint that leaves a stop may still touch it.
  const double inside = std::min(robot_->upper()[i] - q[i], q[i] - robot_->lower()[i]);
  return mode.slides == 0 ? inside : std::min(inside, mode.slides * qd[i]);
}

double JointModes::margin(const double* q, const double* qd, const double* tau) {
  JointVector qdd(robot_->n());
  if (any_stands_ && !accelerate_held(q, qd, tau, qdd.data())) return -1.0;
  double least = kInfinity;
  for (Eigen::Index i = 0; i < robot_->n(); ++i) least = std::min(least, margin_of(i, q, qd));
  return least;
}

void JointModes::look_at_stop(Eigen::Index i, double q) {
  modes_[static_cast<std::size_t>(i)].at_stop = q >= robot_->upper()[i]   ? 1
                                                : q <= robot_->lower()[i] ? -1
                                                                          : 0;
}

bool JointModes::settle(const double* q, const double* qd, const double* tau) {
  const Eigen::Index n = robot_->n();
  any_stands_ = false;
  bool any_may_stand = false;
  for (Eigen::Index i = 0; i < n; ++i) {
    Mode& mode = modes_[static_cast<std::size_t>(i)];
    look_at_stop(i, q[i]);
    const bool dry = has_dry_friction(i);
    mode.stands = may_stand(i, qd[i]);
    mode.slides = !dry ? 0 : qd[i] > 0.0 ? 1 : qd[i] < 0.0 ? -1 : 0;
    any_stands_ = any_may_stand = any_may_stand || mode.stands;
  }
  if (!any_may_stand) return true;
  // One joint after the other is released or held, always the first with a wrong mode; for a
  // positive definite inertia matrix this terminates (K. G. Murty, Opsearch 11, 1974).
  constexpr int kMostRounds = 1000;
  for (int round = 0; round < kMostRounds; ++round) {
    JointVector qdd(n);
    if (!accelerate_held(q, qd, tau, qdd.data())) return false;
    Eigen::Index wrong = 0;
    while (wrong < n && !is_wrong(wrong, qd[wrong], qdd[wrong])) ++wrong;
    if (wrong == n) return true;
    flip(wrong);
  }
  return true;
}

bool JointModes::may_stand(Eigen::Index i, double qd) const {
  return qd == 0.0 && (has_dry_friction(i) || (*this)[i].at_stop != 0);
}

// Held against a larger force than possible, or released and driven back.
bool JointModes::is_wrong(Eigen::Index i, double qd, double qdd) const {
  if (!may_stand(i, qd)) return false;
  const Mode& mode = (*this)[i];
  if (mode.stands) return margin_of(i, nullptr, nullptr) < 0.0;
  return mode.slides * qdd < 0.0 || mode.at_stop * qdd > 0.0;
}

void JointModes::flip(Eigen::Index i) {
  Mode& mode = modes_[static_cast<std::size_t>(i)];
  mode.slides = 0;
  if (mode.stands && has_dry_friction(i)) mode.slides = hold_[i] > range_of(i).highest ? 1 : -1;
  mode.stands = !mode.stands;
  any_stands_ =
      std::any_of(modes_.begin(), modes_.begin() + robot_->n(), std::mem_fn(&Mode::stands));
}

// Joints at rest at their stops take up impulses as well, if these press them against the stops.
bool JointModes::strike(Eigen::Index struck, const double* q, double* qd, double restitution) {
  const Eigen::Index n = robot_->n();
  JointMatrix M(n, n);
  if (is_composed()) {
    M = mass_matrix(*robot_, Eigen::Map<const Eigen::VectorXd>(q, n));
  } else {
    const DynamicsInput in = input_of(*robot_, q);
    kernel_for(kMassKernels, in.plan)(in, M.data());
  }
  std::array<bool, kMaxJoints> rests{};
  for (Eigen::Index i = 0; i < n; ++i) {
    look_at_stop(i, q[i]);
    rests[static_cast<std::size_t>(i)] = i != struck && qd[i] == 0.0 && (*this)[i].at_stop != 0;
  }
  const double after = -restitution * qd[struck];
  JointVector change(n), impulse(n);
  for (bool presses = false; !presses;) {
    change.setZero();
    change[struck] = after - qd[struck];
    const auto moves = [&](Eigen::Index i) {
      return i != struck && !rests[static_cast<std::size_t>(i)];
    };
    if (!solve_part(M, moves, JointVector::Zero(n), change)) return false;
    impulse = M * change;
    presses = true;
    for (Eigen::Index i = 0; i < n && presses; ++i) {
      bool& rest = rests[static_cast<std::size_t>(i)];
      presses = !rest || (*this)[i].at_stop * impulse[i] <= 0.0;
      rest = rest && presses;
    }
  }
  Eigen::Map<Eigen::VectorXd>(qd, n) += change;
  qd[struck] = after;
  return true;
}

}  // namespace armlet
