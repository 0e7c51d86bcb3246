#include "armlet/trajectory/motion_forces.hpp"

#include <algorithm>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

// Looks at one instant after the other.
class ForceSearch {
 public:
  ForceSearch(const Robot& robot, const Trajectory& motion)
      : robot_(robot), motion_(motion), q_(robot.n()), qd_(robot.n()), qdd_(robot.n()) {
    for (int i = 0; i < robot.n(); ++i)
      found_.peaks.push_back({.limit = robot.joint(i).max_effort});
  }

  void look_at(double t) {
    motion_.sample(t, q_, qd_, qdd_);
    const JointVector tau = inverse_dynamics(robot_, q_, qd_, qdd_);
    const JointVector lasting = gravity_forces(robot_, q_) + friction_forces(robot_, qd_);
    for (int i = 0; i < robot_.n(); ++i) {
      PeakForce& peak = found_.peaks[static_cast<std::size_t>(i)];
      if (std::abs(tau[i]) > std::abs(peak.force)) {
        peak.force = tau[i];
        peak.t = t;
      }
      if (std::isfinite(peak.limit))
        found_.slower = std::max(found_.slower, slower(tau[i], lasting[i], peak.limit));
    }
  }

  MotionForces result() {
    double most = 0.0;
    for (int i = 0; i < robot_.n(); ++i) {
      const double share = found_.peaks[static_cast<std::size_t>(i)].share();
      if (share <= most) continue;
      most = share;
      found_.nearest = i;
    }
    if (most <= 1.0) found_.slower = std::min(found_.slower, 1.0);  // it may need its swing
    return std::move(found_);
  }

 private:
  // The k with |lasting + (tau - lasting) / k^2| = limit.
  static double slower(double tau, double lasting, double limit) {
    if (std::abs(lasting) > limit) return kNever;
    const double moving = tau - lasting;
    const double room = moving > 0.0 ? limit - lasting : limit + lasting;
    if (room > 0.0) return std::sqrt(std::abs(moving) / room);
    return moving == 0.0 ? 0.0 : kNever;
  }

  static constexpr double kNever = std::numeric_limits<double>::infinity();
  const Robot& robot_;
  const Trajectory& motion_;
  VectorXd q_, qd_, qdd_;
  MotionForces found_;
};

}  // namespace

bool has_force_limits(const Robot& robot) {
  for (int i = 0; i < robot.n(); ++i) {
    if (std::isfinite(robot.joint(i).max_effort)) return true;
  }
  return false;
}

MotionForces motion_forces(const Robot& robot, const Trajectory& motion) {
  check_size("paths of the motion", motion.n(), robot.n());
  constexpr double kStep = 5e-3;    // s
  constexpr double kMost = 10'000;  // instants
  constexpr double kBeside = 1e-9;  // s, from a knot
  ForceSearch search(robot, motion);
  const double duration = motion.duration();
  const double steps = std::clamp(std::ceil(duration / kStep), 1.0, kMost);
  for (int k = 0; k <= static_cast<int>(steps); ++k) search.look_at(duration * k / steps);
  const std::vector<double> knots = motion.knots();
  if (static_cast<double>(knots.size()) > kMost) return search.result();
  for (const double knot : knots) {
    if (knot > kBeside) search.look_at(knot - kBeside);
    if (knot + kBeside < duration) search.look_at(knot + kBeside);
  }
  return search.result();
}

}  // namespace armlet
