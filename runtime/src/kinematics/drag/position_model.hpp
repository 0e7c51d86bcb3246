#pragma once

#include <vector>

#include "armlet/kinematics/jacobian.hpp"

namespace armlet {

// The distance of a tool point from a goal as a function of the joints, with its exact second
// derivative: at the boundary of the reach the first derivative vanishes, and only the second one
// tells which joints are free to rotate the tool.
//
// Steps are computed in scaled joints: 1 for a radian, and for a prismatic joint 1 for the length
// of the arm.
class PositionModel {
 public:
  PositionModel(const Robot& robot, const Eigen::Isometry3d& T_goal);

  // The Jacobian at a configuration, and what is missing to the goal, [p; log R], m and rad.
  struct At {
    Jacobian J;
    Vector6d error = Vector6d::Zero();
    double distance() const { return error.head<3>().norm(); }
    double angle() const { return error.tail<3>().norm(); }
  };
  At at(const Eigen::VectorXd& q) const;

  // The step of the joints towards the position. Joints at a limit do not move beyond it.
  Eigen::VectorXd step(const Eigen::VectorXd& q, const At& at) const;

  // The damped step of the joints that rotates the tool towards the goal and does not move its
  // point; if the point is at the boundary of the reach, it does not leave the nearest point.
  Eigen::VectorXd rotation_step(const Eigen::VectorXd& q, const At& at, double damping) const;

  // Joints at a limit that would bring the tool nearer beyond it: its orientation if the position
  // is reached, otherwise its point.
  std::vector<int> stopping(const Eigen::VectorXd& q, const At& at, bool has_position) const;

 private:
  using Joints = std::vector<Eigen::Index>;
  Eigen::MatrixXd hessian(const Eigen::VectorXd& q, const At& at) const;
  Joints free_joints(const Eigen::VectorXd& q, const Eigen::VectorXd& push) const;
  bool leaves(const Eigen::VectorXd& q, Eigen::Index i, double direction) const;
  bool drop_leaving(const Eigen::VectorXd& q, const Eigen::VectorXd& step, Joints& joints) const;

  const Robot& robot_;
  Eigen::Isometry3d T_goal_;
  Eigen::VectorXd scale_;
  // m^2: second derivatives up to flat_ are those of directions that do not move the tool point.
  double flat_, damping_;
};

}  // namespace armlet
