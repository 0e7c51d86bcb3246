#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A trajectory that is executed from an instant of the clock on, and can be stopped under control.
//
// Stopping executes the same path ever more slowly until the robot is at rest. The path is never
// left, and no acceleration and no jerk exceeds the larger of the joint's limit and the
// trajectory's own value. The rate of path time falls along the shortest ramp of limited jerk that
// satisfies this. If no such ramp can begin at once, because a joint already decelerates at its
// limit, it begins later.
class Motion {
 public:
  Motion(Trajectory trajectory, std::int64_t start_ns);

  // A trajectory that replaces the rest of another motion and brings the robot to rest earlier: it
  // counts as stopped from the beginning.
  static Motion stopping(Trajectory trajectory, std::int64_t start_ns);

  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }
  [[nodiscard]] std::int64_t start_ns() const { return start_ns_; }

  // The instant at which the robot is at rest.
  [[nodiscard]] std::int64_t end_ns() const { return end_ns_; }

  // Whether the motion was stopped before its end. If the stop came so late that no deceleration
  // fits into the rest of the path, it still runs to the end of the path.
  [[nodiscard]] bool is_stopped() const { return stop_ns_ != kNever; }

  // Begins the deceleration at t_ns; a robot at rest at that instant does not move. No effect if
  // the motion is over or already stopping.
  //
  // max_accel, max_jerk  limits of the joints, > 0.
  void stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel, const Eigen::VectorXd& max_jerk);

  // State at t_ns, without allocation. From end_ns() on the joints are at rest, exactly at the
  // target if it is reached.
  void sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
              Eigen::VectorXd& qdd) const;

 private:
  static constexpr std::int64_t kNever = -1;
  // While the robot decelerates, path time u passes at `rate` times the rate of the clock. The
  // second derivative of `rate` is constant in a piece.
  struct Piece {
    double t;  // since the stop, s
    double u;
    double rate;
    double slope;  // 1/s
    double bend;   // 1/s^2
    double duration;
    [[nodiscard]] double u_at(double dt) const {
      return u + dt * (rate + dt * (0.5 * slope + dt * bend / 6.0));
    }
    [[nodiscard]] double rate_at(double dt) const { return rate + dt * (slope + 0.5 * dt * bend); }
    [[nodiscard]] double slope_at(double dt) const { return slope + dt * bend; }
    [[nodiscard]] Piece next(double next_bend, double next_duration) const;
  };
  struct Limits {
    Eigen::VectorXd accel, jerk;
  };
  [[nodiscard]] bool stands_at(double u) const;
  [[nodiscard]] bool allows(double u, const Piece& piece, double dt, const Limits& limits) const;
  [[nodiscard]] bool fits(const std::vector<Piece>& pieces, const std::vector<double>& knots,
                          const Limits& limits) const;
  [[nodiscard]] std::vector<Piece> brake(double u, double delay, double longest,
                                         const std::vector<double>& knots,
                                         const Limits& limits) const;

  Trajectory trajectory_;
  std::int64_t start_ns_;
  std::int64_t end_ns_;
  std::int64_t stop_ns_ = kNever;
  std::vector<Piece> slowing_;  // empty although stopped: runs to the end of the path
  double u_end_;                // path time at which the robot comes to rest, s
};

}  // namespace armlet
