#include "trajectory/timing/force_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/dynamics/inverse_dynamics.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kLeastSpeed = 1e-4;  // of the highest squared speed, for tangents
// largest part of the room below a limit by which it is reduced
constexpr double kMostTaken = 0.9;

// At path parameter s: joint values, and their derivatives by s.
struct Along {
  VectorXd q, first, second;
};
Along along(const Trajectory& path, double s) {
  Along out{VectorXd(path.n()), VectorXd(path.n()), VectorXd(path.n())};
  path.sample(s, out.q, out.first, out.second);
  return out;
}

}  // namespace

void SpeedStrips::add(double a, double b, double c) {
  if (std::abs(a) < kNoSlope) {
    if (b * x_most > c) x_most = std::max(c, 0.0) / b;
    return;
  }
  (a > 0.0 ? upper : lower).push_back({c / a, -b / a});
}

ForceTerms force_terms(const Robot& robot, const VectorXd& q, const VectorXd& first,
                       const VectorXd& second) {
  const VectorXd still = VectorXd::Zero(q.size());
  ForceTerms at;
  at.g = gravity_forces(robot, q);
  at.a = inverse_dynamics(robot, q, still, first) - at.g;
  at.b = inverse_dynamics(robot, q, still, second) - at.g + coriolis_forces(robot, q, first);
  at.d = first;
  for (Index i = 0; i < q.size(); ++i) {
    const Link& link = robot.motor_link(static_cast<int>(i));
    at.d[i] *= link.gear * link.gear * link.friction.viscous;
  }
  return at;
}

DryFriction dry_friction(const Link& link, std::span<const double> rates) {
  const double gear = std::abs(link.gear);
  DryFriction dry;
  bool none = true;
  const auto include = [&](double force) {
    dry.low = none ? force : std::min(dry.low, force);
    dry.high = none ? force : std::max(dry.high, force);
    none = false;
  };
  for (const double rate : rates) {
    if (rate == 0.0) {
      include(0.0);
      continue;
    }
    include(gear * (rate > 0.0 ? link.friction.coulomb_plus : link.friction.coulomb_minus));
    if (link.friction.stribeck_speed > 0.0)
      include(std::copysign(gear * link.friction.static_torque, rate));
  }
  return dry;
}

ForceBounds::ForceBounds(const Robot& robot, const Trajectory& path)
    : robot_(robot), path_(path), limits_(robot.n()) {
  for (int i = 0; i < robot.n(); ++i) {
    have_viscous_friction_ = have_viscous_friction_ || robot.motor_link(i).friction.viscous != 0.0;
    limits_[i] = robot.joint(i).max_effort;
  }
}

void ForceBounds::lay(const std::vector<double>& s, const std::vector<double>& x_most) {
  s_ = s;
  x_most_ = x_most;
  at_.resize(s.size());
  for (std::size_t k = 0; k < s.size(); ++k) {
    const Along p = along(path_, s[k]);
    at_[k] = force_terms(robot_, p.q, p.first, p.second);
  }
  less_.assign(s.size() - 1, VectorXd::Zero(path_.n()));
  dry_.assign(s.size() - 1, std::vector<DryFriction>(static_cast<std::size_t>(path_.n())));
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    for (Index i = 0; i < path_.n(); ++i) dry_[k][static_cast<std::size_t>(i)] = dry_within(k, i);
  }
  std::vector<double> middle = x_most;
  for (double& x : middle) x *= 0.25;
  linearise_at(middle, 4.0);
  check_holding();
}

// The bounds over all directions in which the joint moves within an interval.
DryFriction ForceBounds::dry_within(std::size_t k, Index i) const {
  const int joint = static_cast<int>(i);
  std::array<double, 3> rates{};
  for (std::size_t at = 0; at < rates.size(); ++at) {
    constexpr std::array<double, 3> kParts = {1e-6, 0.5, 1.0 - 1e-6};
    rates[at] = path_.value(joint, s_[k] + kParts[at] * (s_[k + 1] - s_[k]), 1);
  }
  return dry_friction(robot_.motor_link(joint), rates);
}

void ForceBounds::check_holding() {
  holds_ = true;
  for (std::size_t k = 0; k + 1 < s_.size(); ++k) {
    for (const ForceTerms* at : {&at_[k], &at_[k + 1]}) {
      for (Index i = 0; i < limits_.size(); ++i) {
        const DryFriction& dry = dry_[k][static_cast<std::size_t>(i)];
        if (at->g[i] + dry.high >= limits_[i] || at->g[i] + dry.low <= -limits_[i]) holds_ = false;
      }
    }
  }
}

void ForceBounds::linearise_at(const std::vector<double>& x, double reach) {
  tangent_at_.resize(x.size());
  chord_to_.resize(x.size());
  const double least = kLeastSpeed * *std::ranges::max_element(x);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double at = std::min(std::max(x[k], least), x_most_[k]);
    tangent_at_[k] = std::sqrt(at);
    chord_to_[k] = std::sqrt(std::min(reach * at, x_most_[k]));
  }
}

// One side of the limit of a joint at a position, with the speed there: sign 1 the upper, -1 the
// lower. `twice` is zero at the beginning of the interval.
void ForceBounds::add_row(SpeedStrips& strips, std::size_t position, Index i, double dry,
                          double limit, double sign, double twice) const {
  const ForceTerms& at = at_[position];
  const double d = sign * at.d[i];
  const double room = limit - sign * (at.g[i] + dry);
  double from = 0.0, slope = 0.0;  // of the bound of d sqrt(x) from above
  if (d > 0.0) {
    // Near rest the tangent must still allow x = 0.
    const double v = std::min(tangent_at_[position], std::max(room, 0.0) / d);
    if (v > 0.0) {
      from = 0.5 * d * v;
      slope = 0.5 * d / v;
    }
  } else if (chord_to_[position] > 0.0) {
    slope = d / chord_to_[position];
  }
  const double b = sign * at.b[i] + slope;
  const double scale = 1.0 / limits_[i];
  strips.add(scale * (sign * at.a[i] + twice * b), scale * b, scale * (room - from));
}

void ForceBounds::add_to(SpeedStrips& strips, std::size_t k, double twice) const {
  if (have_viscous_friction()) strips.x_most = std::min(strips.x_most, chord_to_[k] * chord_to_[k]);
  for (Index i = 0; i < limits_.size(); ++i) {
    if (!std::isfinite(limits_[i])) continue;
    const DryFriction& dry = dry_[k][static_cast<std::size_t>(i)];
    const double limit = limits_[i] - less_[k][i];
    for (const double sign : {1.0, -1.0}) {
      const double friction = sign > 0.0 ? dry.high : dry.low;
      add_row(strips, k, i, friction, limit, sign, 0.0);
      add_row(strips, k + 1, i, friction, limit, sign, twice);
    }
  }
}

VectorXd ForceBounds::forces_at(double s, double x, double u) const {
  const Along p = along(path_, s);
  return inverse_dynamics(robot_, p.q, p.first * std::sqrt(x), p.first * u + p.second * x);
}

double ForceBounds::share(double s, double x, double u) const {
  return forces_at(s, x, u).cwiseAbs().cwiseQuotient(limits_).maxCoeff();
}

double ForceBounds::tighten(std::size_t k, double s, double x, double u) {
  const VectorXd force = forces_at(s, x, u);
  double worst = 1.0;
  for (Index i = 0; i < limits_.size(); ++i) {
    const double excess = std::abs(force[i]) - limits_[i];
    if (!(excess > 0.0)) continue;
    double room = limits_[i];
    const DryFriction& dry = dry_[k][static_cast<std::size_t>(i)];
    for (const ForceTerms* at : {&at_[k], &at_[k + 1]})
      room = std::min({room, limits_[i] - at->g[i] - dry.high, limits_[i] + at->g[i] + dry.low});
    less_[k][i] = std::min(less_[k][i] + excess, kMostTaken * room);
    worst = std::max(worst, std::sqrt(1.0 + excess / room));
  }
  return worst;
}

}  // namespace armlet
