#pragma once

#include <cstdint>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A trajectory being executed from an instant of the clock on, which can be stopped under control.
//
// Stopping runs the same path ever more slowly until it stands: the path is never left, and no
// acceleration exceeds the larger of the joint's limit and what the trajectory itself has.
class Motion {
 public:
  Motion(Trajectory trajectory, std::int64_t start_ns);

  [[nodiscard]] const Trajectory& trajectory() const { return trajectory_; }
  [[nodiscard]] std::int64_t start_ns() const { return start_ns_; }

  // The instant at which the robot will stand still.
  [[nodiscard]] std::int64_t end_ns() const { return end_ns_; }

  // True if the end of the trajectory will be reached: always, unless it was stopped in time.
  [[nodiscard]] bool reaches_end() const { return stop_ns_ == kNever; }

  // Begins to slow down at t_ns; nothing happens if that would take longer than arriving, or if it
  // is stopping already.
  //
  // max_accel  acceleration limits of the joints, > 0.
  void stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel);

  // State at t_ns, without allocating. At and after end_ns() the joints stand still, exactly on the
  // target if it is reached.
  void sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
              Eigen::VectorXd& qdd) const;

 private:
  static constexpr std::int64_t kNever = -1;
  // Path time, its rate and the rate's derivative at a clock time while slowing down.
  struct Pace {
    double u;
    double rate;
    double slope;
  };
  [[nodiscard]] Pace pace(double since_stop) const;
  [[nodiscard]] double overload(double slowing, const Eigen::VectorXd& max_accel) const;

  Trajectory trajectory_;
  std::int64_t start_ns_;
  std::int64_t end_ns_;
  std::int64_t stop_ns_ = kNever;
  double u_stop_ = 0.0;   // path time at which slowing down began, s
  double slowing_ = 0.0;  // how long it lasts, s
};

}  // namespace armlet
