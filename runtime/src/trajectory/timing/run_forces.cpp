#include "trajectory/timing/run_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "armlet/dynamics/inverse_dynamics.hpp"

namespace armlet {
namespace {

constexpr double kMostTaken = 0.9;  // largest part of the room below a limit by which it is reduced

}  // namespace

RunForces::RunForces(const Robot& arm, const Trajectory& path, double share, std::size_t cells)
    : arm_(arm),
      path_(path),
      share_(share),
      less_(cells * static_cast<std::size_t>(arm.n()), 0.0),
      room_(less_.size(), std::numeric_limits<double>::infinity()),
      q_(arm.n()),
      first_(arm.n()),
      second_(arm.n()) {
  for (int i = 0; i < arm.n(); ++i) {
    const Friction& friction = arm.motor_link(i).friction;
    rubs_ = rubs_ || friction.coulomb_plus != 0.0 || friction.coulomb_minus != 0.0 ||
            friction.static_torque != 0.0;
  }
}

DryFriction RunForces::dry_between(int joint, double from, double to) const {
  if (!rubs_) return {};
  constexpr std::array<double, 3> kParts = {1e-6, 0.5, 1.0 - 1e-6};
  std::array<double, 3> rates{};
  for (std::size_t k = 0; k < rates.size(); ++k)
    rates[k] = path_.value(joint, from + kParts[k] * (to - from), 1);
  return dry_friction(arm_.motor_link(joint), rates);
}

void RunForces::add_to(SpeedSpline& spline, std::size_t cell, const PathWarp::Along& along,
                       double s, double from, double to) {
  path_.sample(s, q_, first_, second_);
  second_ = second_ * (along.first * along.first) + first_ * along.second;
  first_ *= along.first;
  const ForceTerms at = force_terms(arm_, q_, first_, second_);
  for (int i = 0; i < arm_.n(); ++i) {
    const double limit = arm_.joint(i).max_effort;
    if (!std::isfinite(limit)) continue;
    const DryFriction dry = dry_between(i, from, to);
    const double above = limit - at.g[i] - dry.high, below = limit + at.g[i] + dry.low;
    const std::size_t own = cell * static_cast<std::size_t>(arm_.n()) + static_cast<std::size_t>(i);
    room_[own] = std::min({room_[own], share_ * above, share_ * below});
    if (!(room_[own] > 0.0)) {
      holds_ = false;
      return;
    }
    const double less = std::min(less_[own], kMostTaken * room_[own]);
    const double scale = 1.0 / limit;
    spline.add_force({.ya = 0.5 * scale * at.a[i],
                      .yb = scale * at.b[i],
                      .v = scale * at.d[i],
                      .low = -scale * (share_ * below - less),
                      .high = scale * (share_ * above - less)});
  }
}

double RunForces::tighten(std::size_t cell, const Trajectory& motion, double t) {
  motion.sample(t, q_, first_, second_);
  const JointVector tau = inverse_dynamics(arm_, q_, first_, second_);
  JointVector still = JointVector::Zero(arm_.n());
  if (share_ < 1.0) still = gravity_forces(arm_, q_) + friction_forces(arm_, first_);
  double worst = 1.0;
  for (int i = 0; i < arm_.n(); ++i) {
    const double limit = arm_.joint(i).max_effort;
    // The motion may use only its share, which is equivalent to a limit of `limit` without a share.
    const double asked = still[i] + (tau[i] - still[i]) / share_;
    const double excess = std::abs(asked) - limit;
    if (!(excess > 0.0)) continue;
    const std::size_t own = cell * static_cast<std::size_t>(arm_.n()) + static_cast<std::size_t>(i);
    less_[own] += share_ * excess;
    worst = std::max(worst, std::sqrt(1.0 + share_ * excess / room_[own]));
  }
  return worst;
}

}  // namespace armlet
