// Force limits of the motors of an arm as limits on the speed along a path.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"
#include "trajectory/timing/force_bounds.hpp"
#include "trajectory/timing/path_warp.hpp"
#include "trajectory/timing/speed_spline.hpp"

namespace armlet {

// The forces of the joints along a path, as rows of a SpeedSpline. Dry friction counts with both
// signs where a joint may reverse.
class RunForces {
 public:
  // Keeps references to both.
  //
  // share  part of a limit that is left for the motion after gravity and dry friction: 0 to 1.
  // cells  of the spline.
  RunForces(const Robot& arm, const Trajectory& path, double share, std::size_t cells);

  // Adds the forces at the last point of the spline, which is in a cell at position s.
  //
  // along     of the warp there.
  // from, to  positions around s between which the directions of the joints are taken into account.
  void add_to(SpeedSpline& spline, std::size_t cell, const PathWarp::Along& along, double s,
              double from, double to);

  // Whether motors can hold the arm, and move it slowly, at all points that were added.
  [[nodiscard]] bool hold() const { return holds_; }

  // Reduces the limits in a cell by the excess of a motion at time t; returns the excess as a
  // factor of time.
  double tighten(std::size_t cell, const Trajectory& motion, double t);

 private:
  [[nodiscard]] DryFriction dry_between(int joint, double from, double to) const;

  const Robot& arm_;
  const Trajectory& path_;
  double share_;
  bool rubs_ = false;  // whether there is dry friction
  bool holds_ = true;
  std::vector<double> less_;  // reduction of the limits, by cell, then by joint
  std::vector<double> room_;  // what gravity and friction leave of the limits at least
  Eigen::VectorXd q_, first_, second_;
};

}  // namespace armlet
