#include "armlet/cell/motion.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/cell/clock.hpp"

namespace armlet {

Motion::Motion(Trajectory trajectory, std::int64_t start_ns)
    : trajectory_(std::move(trajectory)),
      start_ns_(start_ns),
      end_ns_(start_ns + to_ns(trajectory_.duration())) {}

Motion::Pace Motion::pace(double since_stop) const {
  const double x = std::clamp(since_stop / slowing_, 0.0, 1.0);
  return {.u = u_stop_ + slowing_ * (x - 0.5 * x * x), .rate = 1.0 - x, .slope = -1.0 / slowing_};
}

// Largest |acceleration| over what is allowed if slowing down took that long: q(u(t)) has
// acceleration q'' rate^2 + q' slope. Sampled, because the product has no handy extremes.
double Motion::overload(double slowing, const Eigen::VectorXd& max_accel) const {
  constexpr int kSamples = 64;
  double worst = 0.0;
  for (int i = 0; i < trajectory_.n(); ++i) {
    const double allowed = std::max(max_accel[i], trajectory_.peak(i, 2));
    for (int k = 0; k <= kSamples; ++k) {
      const double x = static_cast<double>(k) / kSamples;
      const double u = u_stop_ + slowing * (x - 0.5 * x * x);
      const double rate = 1.0 - x;
      const double qdd =
          trajectory_.value(i, u, 2) * rate * rate - trajectory_.value(i, u, 1) / slowing;
      worst = std::max(worst, std::abs(qdd) / allowed);
    }
  }
  return worst;
}

void Motion::stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel) {
  if (stop_ns_ != kNever || t_ns >= end_ns_) return;
  u_stop_ = to_seconds(t_ns - start_ns_);
  constexpr double kShortest = 1e-3;  // s, one tick: also for a robot that hardly moves
  constexpr double kLonger = 1.1;
  double slowing = kShortest;
  for (int i = 0; i < trajectory_.n(); ++i) {
    slowing = std::max(slowing, std::abs(trajectory_.value(i, u_stop_, 1)) / max_accel[i]);
  }
  // Slowing down for that long covers half of it in path time; beyond the end it is not needed.
  const double left = trajectory_.duration() - u_stop_;
  while (0.5 * slowing < left && overload(slowing, max_accel) > 1.0 + 1e-9) slowing *= kLonger;
  if (0.5 * slowing >= left) return;
  stop_ns_ = t_ns;
  slowing_ = slowing;
  end_ns_ = t_ns + to_ns(slowing);
}

void Motion::sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
                    Eigen::VectorXd& qdd) const {
  if (stop_ns_ == kNever || t_ns <= stop_ns_) {
    const double t = t_ns >= end_ns_ ? trajectory_.duration() : to_seconds(t_ns - start_ns_);
    trajectory_.sample(t, q, qd, qdd);
  } else {
    const Pace now = pace(to_seconds(std::min(t_ns, end_ns_) - stop_ns_));
    trajectory_.sample(now.u, q, qd, qdd);
    qdd = qdd * (now.rate * now.rate) + qd * now.slope;
    qd *= now.rate;
  }
  if (t_ns >= end_ns_) {
    qd.setZero();
    qdd.setZero();
  }
}

}  // namespace armlet
