#include "trajectory/velocity/take_up.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trajectory/planners/ramp.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kShortestStep = 1e-12;  // s; shorter steps have no visible effect

// A rotation changes the direction of the acceleration with constant jerk. With N(u) = max |u_i| /
// J_i for its jerks J, the time in which jerks can produce the accelerations u, a rotation of
// duration tau from the acceleration a to a_1 needs N(a - a_1) <= tau. Let e = -x be the missing
// speeds. After the rotation e - (a + a_1) tau / 2 is missing, which has the direction of a_1 if
// a_1 is a multiple of e - a tau / 2. Let y be such that a - y e is a multiple of a - a_1; then
//   a_1 = y (2 e - a tau) / (2 - y tau),  N(a - y e) = tau - y tau^2 / 2.
class AccelerationChange {
 public:
  AccelerationChange(const VectorXd& e, const VectorXd& a, const TakeUpLimits& limits)
      : e_(e), a_(a), limits_(limits) {
    y_ = shortest();
    if (room(y_) < 0.0) y_ = largest_with_room();
    time_ = time_of(y_);
  }

  [[nodiscard]] double time() const { return time_; }
  // The acceleration after the rotation, and the speeds that are missing then.
  [[nodiscard]] VectorXd acceleration() const { return (y_ / (2.0 - y_ * time_)) * ahead(time_); }
  [[nodiscard]] VectorXd lacking() const {
    return ((1.0 - y_ * time_) / (2.0 - y_ * time_)) * ahead(time_);
  }
  // The acceleration as a multiple of the missing speeds.
  [[nodiscard]] double rate() const { return y_ / (1.0 - y_ * time_); }

 private:
  [[nodiscard]] VectorXd ahead(double tau) const { return 2.0 * e_ - tau * a_; }
  [[nodiscard]] double change_time(const VectorXd& u) const {
    return (u.array().abs() / limits_.change.array()).maxCoeff();
  }
  [[nodiscard]] double root(double y, double n) const {
    return 2.0 * n / (1.0 + std::sqrt(std::max(1.0 - 2.0 * y * n, 0.0)));
  }
  [[nodiscard]] double time_of(double y) const { return root(y, change_time(a_ - y * e_)); }

  // N(a - y e) is the maximum of lines p + q y, two for every joint. Along one line the time is
  // monotone in y, and from one line to the next it changes from falling to rising once: the
  // shortest time is at the intersection of two lines.
  struct Line {
    double p, q;
  };
  [[nodiscard]] double shortest() const {
    const Eigen::Index n = e_.size();
    const auto line = [&](Eigen::Index k) {
      const double sign = k < n ? 1.0 : -1.0;
      const Eigen::Index i = k % n;
      return Line{sign * a_[i] / limits_.change[i], -sign * e_[i] / limits_.change[i]};
    };
    Line top = line(0);
    for (Eigen::Index k = 1; k < 2 * n; ++k) {
      const Line each = line(k);
      if (each.p > top.p || (each.p == top.p && each.q > top.q)) top = each;
    }
    double y = 0.0;
    for (Eigen::Index step = 0; step < 2 * n; ++step) {
      const double tau = root(y, std::max(top.p + top.q * y, 0.0));
      if (0.5 * tau * tau + top.q >= 0.0) break;
      double meets = std::numeric_limits<double>::infinity();
      Line next = top;
      for (Eigen::Index k = 0; k < 2 * n; ++k) {
        const Line each = line(k);
        if (each.q <= top.q) continue;
        const double at = std::max((top.p - each.p) / (each.q - top.q), y);
        if (at < meets || (at == meets && each.q > next.q)) {
          meets = at;
          next = each;
        }
      }
      y = meets;
      top = next;
    }
    return y;
  }

  // Not negative if the acceleration after the rotation is within its limit and can still be
  // brought to zero before the error changes its sign.
  [[nodiscard]] double room(double y) const {
    const double tau = time_of(y);
    const VectorXd to = ahead(tau);
    const double gain = (to.array().abs() / limits_.acceleration.array()).maxCoeff();
    const double stop = (to.array().abs() / limits_.jerk.array()).maxCoeff();
    const double still = (1.0 - y * tau) * (2.0 - y * tau) - 0.5 * y * y * stop;
    return std::min(still, 2.0 - y * tau - y * gain);
  }
  // Searched downwards from the shortest rotation, because there may be more than one.
  [[nodiscard]] double largest_with_room() const {
    constexpr int kSteps = 64;
    constexpr int kBisections = 100;
    double good = 0.0, bad = y_;
    for (int k = kSteps - 1; k > 0; --k) {
      const double y = y_ * k / kSteps;
      if (room(y) >= 0.0) {
        good = y;
        break;
      }
      bad = y;
    }
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (good + bad);
      if (middle == good || middle == bad) break;
      (room(middle) >= 0.0 ? good : bad) = middle;
    }
    return good;
  }

  const VectorXd& e_;
  const VectorXd& a_;
  const TakeUpLimits& limits_;
  double y_ = 0.0;
  double time_ = 0.0;
};

}  // namespace

TakeUp plan_take_up(const VectorXd& x, const VectorXd& a, const TakeUpLimits& limits) {
  TakeUp plan{.x0 = x, .a0 = a};
  const VectorXd e = -x;
  const AccelerationChange change(e, a, limits);
  const auto add = [&](double duration, const VectorXd& jerk) {
    if (duration >= kShortestStep) plan.pieces.push_back({duration, jerk});
  };
  if (change.time() >= kShortestStep)
    add(change.time(), (change.acceleration() - a) / change.time());
  // Along the straight line the error is a multiple of the missing speeds, from 1 to 0.
  const VectorXd lacking = change.lacking();
  const double most = (lacking.array().abs() / limits.acceleration.array()).maxCoeff();
  const double quickest = (lacking.array().abs() / limits.jerk.array()).maxCoeff();
  if (!(most > 0.0) || !std::isfinite(change.rate())) return plan;
  const Ramp ramp = make_ramp(0.0, change.rate(), 1.0, 1.0 / most, 1.0 / quickest);
  add(ramp.rise, ramp.jerk * lacking);
  add(ramp.hold, VectorXd::Zero(x.size()));
  add(ramp.fall, -ramp.jerk * lacking);
  return plan;
}

TakeUp sum_of(const TakeUp& first, const TakeUp& second) {
  TakeUp sum{.x0 = first.x0 + second.x0, .a0 = first.a0 + second.a0};
  const auto jerk_at = [](const TakeUp& each, double t) {
    for (const TakeUpPiece& piece : each.pieces) {
      if (t < piece.duration) return piece.jerk;
      t -= piece.duration;
    }
    return VectorXd(VectorXd::Zero(each.x0.size()));
  };
  std::vector<double> knots;
  for (const TakeUp* each : {&first, &second}) {
    double t = 0.0;
    for (const TakeUpPiece& piece : each->pieces) knots.push_back(t += piece.duration);
  }
  std::ranges::sort(knots);
  double t = 0.0;
  for (const double knot : knots) {
    if (knot - t < kShortestStep) continue;
    const double middle = 0.5 * (t + knot);
    sum.pieces.push_back({knot - t, jerk_at(first, middle) + jerk_at(second, middle)});
    t = knot;
  }
  return sum;
}

TakeUp::State TakeUp::at(double t) const {
  State state{x0, a0};
  for (const TakeUpPiece& piece : pieces) {
    const double dt = std::min(t, piece.duration);
    state.x += dt * (state.a + (0.5 * dt) * piece.jerk);
    state.a += dt * piece.jerk;
    t -= piece.duration;
    if (t <= 0.0) return state;
  }
  return {VectorXd::Zero(x0.size()), VectorXd::Zero(x0.size())};
}

double TakeUp::duration() const {
  double total = 0.0;
  for (const TakeUpPiece& piece : pieces) total += piece.duration;
  return total;
}

}  // namespace armlet
