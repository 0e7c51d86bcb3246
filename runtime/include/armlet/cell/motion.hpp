#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A trajectory being executed from an instant of the clock on, which can be stopped under control.
//
// Stopping runs the same path ever more slowly until it stands: the path is never left, and no
// acceleration and no jerk exceeds the larger of the joint's limit and what the trajectory itself
// has. The rate of the run falls along a ramp of limited jerk, the shortest that keeps to this; if
// none does at once, because a joint slows down as fast as it may already, it begins later.
class Motion {
 public:
  Motion(Trajectory trajectory, std::int64_t start_ns);

  // A trajectory that brings the robot to rest before the end of another motion: it counts as
  // stopped from the beginning.
  static Motion stopping(Trajectory trajectory, std::int64_t start_ns);

  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }
  [[nodiscard]] std::int64_t start_ns() const { return start_ns_; }

  // The instant at which the robot will stand still.
  [[nodiscard]] std::int64_t end_ns() const { return end_ns_; }

  // Whether it was stopped before its end. Stopped so late that the path cannot be left out any
  // more, it still runs to the end of the path.
  [[nodiscard]] bool is_stopped() const { return stop_ns_ != kNever; }

  // Begins to slow down at t_ns; a robot that stands at that instant stays where it is. Nothing
  // happens if the motion is over or stopping already.
  //
  // max_accel, max_jerk  limits of the joints, > 0.
  void stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel, const Eigen::VectorXd& max_jerk);

  // State at t_ns, without allocating. At and after end_ns() the joints stand still, exactly on the
  // target if it is reached.
  void sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
              Eigen::VectorXd& qdd) const;

 private:
  static constexpr std::int64_t kNever = -1;
  // While slowing down, path time u runs at `rate` times the clock, whose second derivative is
  // constant in a piece.
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
