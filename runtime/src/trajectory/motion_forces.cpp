#include "armlet/trajectory/motion_forces.hpp"

#include <algorithm>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "trajectory/roots.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kBeside = 1e-9;   // s, distance from a knot
constexpr double kAtRest = 1e-12;  // rad/s or m/s: rounding of a rate that is zero
constexpr double kStands = 1e-9;   // rad/s^2 or m/s^2: rounding of an acceleration that is zero
constexpr double kNever = std::numeric_limits<double>::infinity();

// Bounds of the friction of a joint that moves in one direction: the part that decreases with the
// speed, and the smallest and largest of the rest, because Stribeck friction changes with the
// speed.
struct JointFriction {
  double viscous = 0.0, dry_low = 0.0, dry_high = 0.0;
};

JointFriction friction_of(const Link& link, double qd) {
  JointFriction out{.viscous = link.gear * link.gear * link.friction.viscous * qd};
  if (qd == 0.0) return out;
  const Friction& friction = link.friction;
  const double gear = std::abs(link.gear);
  const double sliding = gear * (qd > 0.0 ? friction.coulomb_plus : friction.coulomb_minus);
  const double standing =
      friction.stribeck_speed > 0.0 ? std::copysign(gear * friction.static_torque, qd) : sliding;
  out.dry_low = std::min(sliding, standing);
  out.dry_high = std::max(sliding, standing);
  return out;
}

// The smallest k from which on moving / k^2 + viscous / k is at most `room`.
double slower_for(double moving, double viscous, double room) {
  if (!(room >= 0.0)) return kNever;
  if (moving <= 0.0 && viscous <= 0.0) return 0.0;
  const double square = viscous * viscous + 4.0 * moving * room;
  if (square < 0.0) return 0.0;
  // The largest root of room k^2 - viscous k - moving.
  const double root = std::sqrt(square);
  if (viscous >= 0.0) return room > 0.0 ? (viscous + root) / (2.0 * room) : kNever;
  return 2.0 * moving / (root - viscous);
}

// Computes the loads of the motors at instants of a motion.
class ForceSearch {
 public:
  ForceSearch(const Robot& robot, const Trajectory& motion)
      : robot_(robot),
        motion_(motion),
        q_(robot.n()),
        qd_(robot.n()),
        qdd_(robot.n()),
        shares_(VectorXd::Zero(robot.n())) {
    for (int i = 0; i < robot.n(); ++i)
      found_.peaks.push_back({.limit = robot.joint(i).max_effort});
  }

  // Dry friction has no direction at the instant when a joint comes to rest or starts, but it has
  // one just before and after.
  [[nodiscard]] bool turns_back(int i) const {
    return std::abs(qd_[i]) < kAtRest && std::abs(qdd_[i]) > kStands;
  }

  // The largest load at an instant: the force of a motor divided by its limit.
  double measure(double t) {
    motion_.sample(t, q_, qd_, qdd_);
    tau_ = inverse_dynamics(robot_, q_, qd_, qdd_);
    double largest = 0.0;
    for (int i = 0; i < robot_.n(); ++i) {
      PeakForce& peak = found_.peaks[static_cast<std::size_t>(i)];
      if (turns_back(i)) continue;
      shares_[i] = std::abs(tau_[i]) / peak.limit;
      largest = std::max(largest, shares_[i]);
      if (std::abs(tau_[i]) <= std::abs(peak.force)) continue;
      peak.force = tau_[i];
      peak.t = t;
    }
    return largest;
  }

  // The load of each motor at the last instant that `measure` computed.
  [[nodiscard]] const VectorXd& shares() const { return shares_; }

  // The factor by which the motion has to be slower so that this instant keeps the limits.
  double look_at(double t) {
    (void)measure(t);
    const JointVector& tau = tau_;
    const JointVector gravity = gravity_forces(robot_, q_);
    const JointVector friction = friction_forces(robot_, qd_);
    double slower = 0.0;
    for (int i = 0; i < robot_.n(); ++i) {
      const PeakForce& peak = found_.peaks[static_cast<std::size_t>(i)];
      if (turns_back(i) || !std::isfinite(peak.limit)) continue;
      const JointFriction f = friction_of(robot_.motor_link(i), qd_[i]);
      const double moving = tau[i] - gravity[i] - friction[i];
      slower =
          std::max({slower, slower_for(moving, f.viscous, peak.limit - gravity[i] - f.dry_high),
                    slower_for(-moving, -f.viscous, peak.limit + gravity[i] + f.dry_low)});
    }
    found_.slower = std::max(found_.slower, slower);
    return slower;
  }

  // Whether no load so far exceeds the limit.
  [[nodiscard]] bool is_within() const {
    return std::ranges::all_of(found_.peaks,
                               [](const PeakForce& peak) { return peak.share() <= 1.0; });
  }

  MotionForces result() {
    double most = 0.0;
    for (int i = 0; i < robot_.n(); ++i) {
      const double share = found_.peaks[static_cast<std::size_t>(i)].share();
      if (share <= most) continue;
      most = share;
      found_.nearest = i;
    }
    // A motion within its limits has the factor 1: its inertia may help the motors, so that at some
    // instants a slower motion would need more force.
    if (most <= 1.0) found_.slower = found_.nearest < 0 ? 0.0 : 1.0;
    return std::move(found_);
  }

 private:
  const Robot& robot_;
  const Trajectory& motion_;
  VectorXd q_, qd_, qdd_, shares_;
  JointVector tau_;
  MotionForces found_;
};

struct Instant {
  double t = 0.0, load = 0.0;
};

// The highest load between two instants. Its time is found to a thousandth of their distance.
template <typename Look>
void climb(const Look& look, double from, double to) {
  constexpr double kGolden = 0.6180339887498949;
  double a = from, b = to;
  double low = b - kGolden * (b - a), high = a + kGolden * (b - a);
  double at_low = look(low), at_high = look(high);
  for (int k = 0; k < 12; ++k) {
    if (at_low > at_high) {
      b = high;
      high = low;
      at_high = at_low;
      low = b - kGolden * (b - a);
      at_low = look(low);
    } else {
      a = low;
      low = high;
      at_low = at_high;
      high = a + kGolden * (b - a);
      at_high = look(high);
    }
  }
}

// Searches for peaks next to the instants with the highest loads, between both of their neighbours.
template <typename Look>
void look_closer(const std::vector<Instant>& seen, const Look& look) {
  constexpr std::size_t kMostPeaks = 300;
  constexpr double kNearly = 0.98;  // of the highest load; peaks next to lower ones are not higher
  double highest = 0.0;
  for (const Instant& at : seen) highest = std::max(highest, at.load);
  if (!(highest > 0.0) || !std::isfinite(highest)) return;
  std::vector<std::size_t> peaks;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const bool rises = k == 0 || seen[k - 1].load <= seen[k].load;
    const bool falls = k + 1 == seen.size() || seen[k + 1].load <= seen[k].load;
    if (rises && falls && seen[k].load >= kNearly * highest) peaks.push_back(k);
  }
  std::ranges::stable_sort(
      peaks, [&](std::size_t a, std::size_t b) { return seen[a].load > seen[b].load; });
  if (peaks.size() > kMostPeaks) peaks.resize(kMostPeaks);
  for (const std::size_t k : peaks) {
    climb(look, seen[k == 0 ? 0 : k - 1].t, seen[std::min(k + 1, seen.size() - 1)].t);
  }
}

// The instants just before and after a joint reverses, where its dry friction reverses too.
void add_reversals(const Trajectory& motion, std::vector<double>& t) {
  for (int i = 0; i < motion.n(); ++i) {
    for (const Segment& piece : motion.joint(i).segments) {
      for (const double u : sign_changes(piece, 1)) {
        t.push_back(std::max(piece.start + u - kBeside, 0.0));
        t.push_back(std::min(piece.start + u + kBeside, motion.duration()));
      }
    }
  }
}

// Instants at most 5 ms apart, and at both ends and in the middle of the pieces of the motion.
std::vector<double> instants_of(const Trajectory& motion) {
  constexpr double kStep = 5e-3;    // s
  constexpr double kMost = 10'000;  // largest number of instants
  const double duration = motion.duration();
  const double steps = std::clamp(std::ceil(duration / kStep), 1.0, kMost);
  std::vector<double> t;
  for (int k = 0; k <= static_cast<int>(steps); ++k) t.push_back(duration * k / steps);
  const std::vector<double> knots = motion.knots();
  if (static_cast<double>(knots.size()) > kMost) return t;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (knots[k] > kBeside) t.push_back(knots[k] - kBeside);
    if (knots[k] + kBeside < duration) t.push_back(knots[k] + kBeside);
    if (k > 0) t.push_back(0.5 * (knots[k - 1] + knots[k]));
  }
  add_reversals(motion, t);
  std::ranges::sort(t);
  return t;
}

// Whether the distance of every joint from its limit is larger than the change of its load from one
// instant to the next. Then no limit is exceeded between the instants, and the factor for a slower
// motion, which takes twice as long to compute, is not needed.
bool is_clear(ForceSearch& search, const std::vector<double>& times) {
  const auto measure = [&search](double t) { return search.measure(t); };
  std::vector<Instant> seen;
  VectorXd before;
  for (const double t : times) {
    seen.push_back({t, measure(t)});
    const VectorXd& now = search.shares();
    if (before.size() == 0) before = now;
    if (!((now.cwiseMax(before) + (now - before).cwiseAbs()).maxCoeff() <= 1.0)) return false;
    before = now;
  }
  look_closer(seen, measure);
  return search.is_within();
}

}  // namespace

bool has_force_limits(const Robot& robot) {
  if (!robot.spec().no_dynamics.empty()) return false;
  for (int i = 0; i < robot.n(); ++i) {
    if (std::isfinite(robot.joint(i).max_effort)) return true;
  }
  return false;
}

MotionForces motion_forces(const Robot& robot, const Trajectory& motion) {
  check_size("paths of the motion", motion.n(), robot.n());
  const std::vector<double> times = instants_of(motion);
  ForceSearch search(robot, motion);
  if (!is_clear(search, times)) {
    const auto look = [&search](double t) { return search.look_at(t); };
    std::vector<Instant> seen;
    for (const double t : times) seen.push_back({t, look(t)});
    look_closer(seen, look);
  }
  return search.result();
}

MotionForces command_forces(const Robot& robot, const Trajectory& motion, double from,
                            double until) {
  constexpr double kStep = 5e-3;  // s
  constexpr double kMost = 10'000;
  check_size("paths of the motion", motion.n(), robot.n());
  const double held = std::min(until, motion.duration());
  ForceSearch search(robot, motion);
  const auto look = [&](double t) {
    if (search.measure(t) > 1.0) search.look_at(t);
  };
  const double length = std::max(held - from, 0.0);
  const double steps = std::clamp(std::ceil(length / kStep), 1.0, kMost);
  for (int k = 0; k <= static_cast<int>(steps); ++k) look(from + length * k / steps);
  for (int i = 0; i < motion.n(); ++i) {
    for (const Segment& piece : motion.joint(i).segments) {
      if (piece.start <= from + kBeside || piece.start > held) continue;
      look(piece.start - kBeside);
      look(std::min(piece.start + kBeside, held));
    }
  }
  return search.result();
}

}  // namespace armlet
