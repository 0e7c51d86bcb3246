// Places on a straight line solved to joints, as finely as the joints need it.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// The line is run in unit time: at time x the tool has covered 10 x^3 - 15 x^4 + 6 x^5 of it.
class LineSamples {
 public:
  LineSamples(const Robot& robot, const Eigen::VectorXd& q0, const Eigen::Isometry3d& T_world_goal,
              IkTask task);

  // Samples the line; false if it cannot be followed, then fault() says why.
  bool follow();
  [[nodiscard]] const LineFault& fault() const { return fault_; }

  // The joint motion of one second through all samples. Only after follow() succeeded.
  [[nodiscard]] Trajectory motion() const;

 private:
  struct Sample {
    double x;
    Eigen::VectorXd q;
  };

  [[nodiscard]] Eigen::Isometry3d pose_at(double x) const;
  [[nodiscard]] IkResult solve(double x, const Eigen::VectorXd& seed,
                               bool respect_limits = true) const;
  bool extend(double x, int halvings);
  bool refine();
  [[nodiscard]] bool strays(const Trajectory& motion, double x) const;
  bool fail(const Sample& last, double x, IkResult ik);

  const Robot& robot_;
  Eigen::Isometry3d T_world_start_;
  Eigen::Isometry3d T_world_goal_;
  IkTask task_;
  std::vector<Sample> samples_;
  LineFault fault_;
};

}  // namespace armlet
