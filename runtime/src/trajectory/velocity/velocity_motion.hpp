// Common parts of the plans of velocity commands for joints and for the tool.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "trajectory/planners/ramp.hpp"

namespace armlet {

inline constexpr double kShortestVelocity = 1e-9;  // s

// throws  ArgumentError for sizes that differ, numbers that are not finite, or no duration.
void check_start(const Robot& robot, const VelocityStart& start);

Eigen::VectorXd accelerations_of(const VelocityStart& start);

// A motion that is built piece by piece for each joint.
class VelocityPieces {
 public:
  explicit VelocityPieces(const VelocityStart& start)
      : paths_(static_cast<std::size_t>(start.q.size())),
        ends_(paths_.size(), 0.0),
        q_(start.q),
        qd_(start.qd),
        qdd_(accelerations_of(start)) {}

  [[nodiscard]] const Eigen::VectorXd& q() const { return q_; }
  [[nodiscard]] const Eigen::VectorXd& qd() const { return qd_; }
  [[nodiscard]] const Eigen::VectorXd& qdd() const { return qdd_; }

  // Constant jerk of joint i.
  void push(Eigen::Index i, double jerk, double T) {
    constexpr double kShortestStep = 1e-14;  // s; shorter steps have no visible effect
    if (T < kShortestStep) return;
    add(i, {.duration = T, .degree = 3, .c = {q_[i], qd_[i], 0.5 * qdd_[i], jerk / 6.0}});
    const AxisState next = after({.q = q_[i], .v = qd_[i], .a = qdd_[i]}, jerk, T);
    set(i, next);
  }

  // Adds a ramp of joint i, cut off after `longest` seconds.
  void ramp(Eigen::Index i, const Ramp& ramp, double longest) {
    push(i, ramp.jerk, std::min(ramp.rise, longest));
    push(i, 0.0, std::min(ramp.hold, longest - ramp.rise));
    push(i, -ramp.jerk, std::min(ramp.fall, longest - ramp.rise - ramp.hold));
  }

  // Sets the speed of joint i exactly; it is constant from now on.
  void settle(Eigen::Index i, double v) {
    qd_[i] = v;
    qdd_[i] = 0.0;
  }

  // Moves joint i to a given state.
  void join(Eigen::Index i, const AxisState& to, double T) {
    add(i, quintic_segment({.q = q_[i], .v = qd_[i], .a = qdd_[i]}, to, T));
    set(i, to);
  }

  // Brings joint i to a given speed and acceleration.
  void gain(Eigen::Index i, double v, double a, double T) {
    const double dv = v - qd_[i] - T * qdd_[i], da = T * (a - qdd_[i]);
    const double c3 = (dv - da / 3.0) / (T * T), c4 = (da - 2.0 * dv) / (4.0 * T * T * T);
    const double travel = T * (qd_[i] + T * (0.5 * qdd_[i] + T * (c3 + T * c4)));
    add(i, {.duration = T, .degree = 4, .c = {q_[i], qd_[i], 0.5 * qdd_[i], c3, c4}});
    set(i, {.q = q_[i] + travel, .v = v, .a = a});
  }

  [[nodiscard]] Trajectory made() && {
    for (Eigen::Index i = 0; i < q_.size(); ++i) paths_[static_cast<std::size_t>(i)].q_end = q_[i];
    return {std::move(paths_), *std::ranges::max_element(ends_)};
  }

 private:
  void add(Eigen::Index i, Segment piece) {
    const auto k = static_cast<std::size_t>(i);
    piece.start = ends_[k];
    ends_[k] += piece.duration;
    paths_[k].segments.push_back(piece);
  }
  void set(Eigen::Index i, const AxisState& s) {
    q_[i] = s.q;
    qd_[i] = s.v;
    qdd_[i] = s.a;
  }

  std::vector<JointPath> paths_;
  std::vector<double> ends_;
  Eigen::VectorXd q_, qd_, qdd_;
};

// Ends a motion: all joints come to rest together.
void come_to_rest(const Robot& robot, VelocityPieces& pieces);

// The first joint that would exceed its speed limit.
std::optional<RateTooHigh> too_fast(const Robot& robot, const Eigen::VectorXd& rates);

// The plan for a motion that ends at rest, if it keeps the limits.
VelocityPlan checked(const Robot& robot, Trajectory motion);

}  // namespace armlet
