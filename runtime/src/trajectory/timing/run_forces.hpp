// What the motors of an arm give, as limits on the speed along a path.
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
// its signs where a joint may turn back.
class RunForces {
 public:
  // Keeps references to both.
  //
  // share  of what gravity and dry friction leave of a limit, that motion may take: 0 to 1.
  // cells  of the spline.
  RunForces(const Robot& arm, const Trajectory& path, double share, std::size_t cells);

  // At the last point of the spline, which lies in a cell at position s.
  //
  // along     of the warp there.
  // from, to  positions around s between which the directions of the joints count.
  void add_to(SpeedSpline& spline, std::size_t cell, const PathWarp::Along& along, double s,
              double from, double to);

  // Whether motors can hold the arm, and move it slowly, at all points that were added.
  [[nodiscard]] bool hold() const { return holds_; }

  // Takes what a motion asks beyond the limits at time t from what they are in a cell; by which
  // factor of time it is too much.
  double tighten(std::size_t cell, const Trajectory& motion, double t);

 private:
  [[nodiscard]] DryFriction dry_between(int joint, double from, double to) const;

  const Robot& arm_;
  const Trajectory& path_;
  double share_;
  bool rubs_ = false;  // any dry friction
  bool holds_ = true;
  std::vector<double> less_;  // taken from the limits, by cell, then by joint
  std::vector<double> room_;  // the least that gravity and friction leave of them
  Eigen::VectorXd q_, first_, second_;
};

}  // namespace armlet
