#pragma once

#include <array>

#include "armlet/kinematics/ik.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "ik_steps.hpp"

namespace armlet {

// Joint values with storage inside the object, so that the iterations do not allocate.
using JointArray = std::array<double, kMaxJoints>;

// Size of the error of a configuration, for rows with a weight.
struct IkError {
  double position = 0.0;  // m
  double rotation = 0.0;  // rad
};

// The rows [p; R] of a goal at a configuration, each times its weight.
struct IkRows {
  Vector6d error;  // m and rad, the rotation by its true angle
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints> J;
};

// The goal of the iterations: a pose with a weight for each row of the error [p; log R]. A row with
// weight 0 is left out.
struct IkGoal {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Vector6d weights = Vector6d::Ones();
  bool in_tool_axes = false;
  double position_tolerance = 1e-6;
  double rotation_tolerance = 1e-6;

  // A goal with the same position and any orientation.
  IkGoal without_orientation() const {
    IkGoal position_only = *this;
    position_only.weights.tail<3>().setZero();
    return position_only;
  }
  bool is_met(const IkError& error) const {
    return error.position <= position_tolerance && error.rotation <= rotation_tolerance;
  }
};

// The largest step of an iteration, and the condition for giving up a start: `stall` consecutive
// iterations without reducing the energy below `progress` times the least so far.
struct IkPace {
  double largest_step = 1.0;  // rad or m
  double progress = 1.0;
  int stall = 7;
};

// The iterations for one arm and one goal.
class IkSolver {
 public:
  IkSolver(const Robot& robot, const IkGoal& goal, const IkPace& pace = {});

  // Levenberg-Marquardt without limits, damping proportional to the error (Chan and Lawrence,
  // 1988). A constant damping would make convergence near a singular goal linear; vanishing damping
  // keeps it fast. Returns whether q meets the tolerances, and then polishes it.
  bool solve_free(JointArray& q, int iterations);

  // Levenberg-Marquardt inside the limits: joints on a bound that the step would push out are
  // frozen.
  bool solve_in_box(JointArray& q, int iterations);

  // Two steps from near a solution. Returns whether the error was below `error` after the first, m
  // and rad together; the second leaves about its square.
  bool correct(JointArray& q, double error);

  // Least squares inside the limits for goals that cannot be reached: gain-ratio damping (Nielsen,
  // 1999), because damping that follows the error stalls when the error cannot vanish.
  void minimise_in_box(JointArray& q, int iterations);

  // The error of q with the true rotation angle.
  IkError error_of(const JointArray& q);
  IkRows rows_of(const JointArray& q);

  bool is_within_limits(const JointArray& q) const;

  int iterations_used() const { return iterations_used_; }

 private:
  using Step = JointArray;
  using Frozen = std::array<bool, kMaxJoints>;

  void pose_and_jacobian(const JointArray& q, double* T_world_tool);
  JointArray rows_at(const JointArray& q) const;  // values of the rows of an arm with mimic joints
  double evaluate(const JointArray& q);  // fills error, J, energy and sizes; returns the energy
  double iterate(const JointArray& q, bool in_box);  // the normal equations and the step too
  Eigen::Vector3d rotation_error(const double* T_world_tool, bool exact) const;
  bool move(JointArray& q) const;
  void rotate_rows(const Eigen::Matrix3d& R);
  void select_rows();
  bool converged() const;
  void polish(JointArray& q, bool in_box);
  double promised_energy(const JointArray& q, const JointArray& next) const;
  void normal_equations();
  // Solves (J^T J + damping I) step = J^T e for the joints that are not frozen.
  Step solve_step(double damping) const;
  Step solve_step(double damping, const Frozen& frozen) const;
  Step step_in_box(const JointArray& q, double damping) const;
  void clamp(JointArray& q) const;
  bool solve(JointArray& q, int iterations, bool in_box);
  bool is_inside(const JointArray& q) const;  // no joint on a bound or beyond

  const WalkPlan& plan_;
  const JointCoupling* coupling_;
  PoseKernel* pose_kernel_;
  PoseAndJacobianKernel* kernel_;
  IterationKernel* iteration_kernel_;
  NormalKernel* normal_kernel_;
  StepKernel* step_kernel_;
  IkGoal goal_;
  std::size_t n_;
  const double *lower_, *upper_;  // of the robot
  bool selective_;                // not all rows have equal weight
  bool plain_;                    // all rows have equal weight, in world axes
  IkIterate at_;                  // written by evaluate() and iterate() before any use
  IkPace pace_;
  bool exact_angle_ = false;
  int iterations_used_ = 0;
};

// Element `index` of a low-discrepancy sequence in the joint ranges (Halton, 1960); ranges of
// revolute joints count as one revolution at most. Index 0 is the middle. Without limits revolute
// joints use a whole revolution, prismatic ones their range extended by the arm's length on either
// side.
JointArray halton_start(const Robot& robot, int index, bool inside_limits = true);
// Element `index` of the sequence for a joint, between 0 and 1.
double halton_share(int joint, int index);

JointArray to_array(const Eigen::VectorXd& q);
Eigen::VectorXd to_vector(const JointArray& q, int n);

}  // namespace armlet
