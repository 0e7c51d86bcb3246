#include "armlet/trajectory/damped_line.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/spline.hpp"
#include "trajectory/curve_plan.hpp"

namespace armlet {
namespace {

constexpr int kSteps = 512;
constexpr int kCorrections = 2;  // per step
constexpr int kPerInterval = 4;  // places between two steps at which the deviation is looked at

double covered(double x) { return x * x * x * (10.0 + x * (-15.0 + 6.0 * x)); }

// One damped step of the joints towards a pose. The damping grows from 0 as the smallest singular
// value falls below its limit, so the step is exact where the arm is not near a singularity.
void step_towards(const Robot& robot, const Eigen::Isometry3d& T_world_tool, double damping,
                  Eigen::VectorXd& q) {
  Jacobian J;
  const Vector6d error = pose_error(forward_and_jacobian(robot, q, J), T_world_tool);
  Eigen::Matrix<double, 6, 6> square = J * J.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(square,
                                                                         Eigen::EigenvaluesOnly);
  const double smallest = std::max(eigen.eigenvalues()[0], 0.0);
  const double limit = damping * damping;
  if (smallest < limit) square.diagonal().array() += limit - smallest;
  q += J.transpose() * square.ldlt().solve(error);
}

void measure(const Robot& robot, const Trajectory& motion, const CurvePiece& line,
             DampedLine& plan) {
  Eigen::VectorXd q(robot.n());
  constexpr int kPlaces = kSteps * kPerInterval;
  for (int k = 0; k <= kPlaces; ++k) {
    const double x = static_cast<double>(k) / kPlaces;
    for (int i = 0; i < robot.n(); ++i) q[i] = motion.value(i, x);
    const Vector6d error = pose_error(forward(robot, q), line.at(covered(x)));
    if (error.head<3>().norm() > plan.deviation) {
      plan.deviation = error.head<3>().norm();
      plan.at = covered(x);
    }
    plan.turn = std::max(plan.turn, error.tail<3>().norm());
  }
}

}  // namespace

DampedLine plan_damped_line(const Robot& robot, const LineMove& move, double damping) {
  check_line_move(robot, move);
  check_positive("damping", damping);
  if (move.task != IkTask::kPose) {
    throw ArgumentError("A damped line needs a goal with an orientation of its own.");
  }
  const CurvePiece line = straight_piece(forward(robot, move.q0), move.T_world_goal);
  DampedLine plan;
  plan.length = (line.T_end.translation() - line.T_start.translation()).norm();
  std::vector<double> x = {0.0};
  std::vector<Eigen::VectorXd> joints = {move.q0};
  for (int k = 1; k <= kSteps; ++k) {
    x.push_back(static_cast<double>(k) / kSteps);
    Eigen::VectorXd q = joints.back();
    for (int j = 0; j < kCorrections; ++j)
      step_towards(robot, line.at(covered(x.back())), damping, q);
    joints.push_back(std::move(q));
  }
  std::vector<JointPath> paths;
  std::vector<double> values(joints.size());
  for (int i = 0; i < robot.n(); ++i) {
    for (std::size_t k = 0; k < joints.size(); ++k) values[k] = joints[k][i];
    paths.push_back({.segments = cubic_spline(x, values), .q_end = values.back()});
  }
  const Trajectory unit(std::move(paths), 1.0);
  measure(robot, unit, line, plan);
  plan.motion = run_unit_motion(robot, move, unit, plan.length);
  return plan;
}

}  // namespace armlet
