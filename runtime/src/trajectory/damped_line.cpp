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
constexpr double kTurnCounts = 0.2;  // m, what a turn by one radian counts for
constexpr double kCatchUp = 4.0;     // largest step, as a multiple of the mean one
constexpr double kSettled = 0.1;     // of the largest step: what a correction is made for
constexpr int kPerInterval = 4;      // places between two steps at which the deviation is looked at

double covered(double x) { return x * x * x * (10.0 + x * (-15.0 + 6.0 * x)); }

// The error of the tool, and the Jacobian of what of it counts: all, or the place.
struct Offset {
  Eigen::VectorXd error;
  Eigen::MatrixXd J;
};

Offset offset_from(const Robot& robot, const Eigen::Isometry3d& T_world_tool, IkTask task,
                   const Eigen::VectorXd& q) {
  Jacobian J;
  const Vector6d error = pose_error(forward_and_jacobian(robot, q, J), T_world_tool);
  if (task == IkTask::kPlace) return {error.head<3>(), J.topRows<3>()};
  return {error, J};
}

// Metres that an offset counts for.
double size_of(const Eigen::VectorXd& error) {
  return error.head<3>().norm() + (error.size() > 3 ? kTurnCounts * error.tail<3>().norm() : 0.0);
}

// One damped step of the joints towards a pose, at most `most` of it. The damping grows from 0 as
// the smallest singular value falls below its limit, so the step is exact where the arm is not near
// a singularity. What is left behind there is caught up with slowly.
void step_towards(const Robot& robot, const Eigen::Isometry3d& T_world_tool, IkTask task,
                  double damping, double most, Eigen::VectorXd& q) {
  auto [error, J] = offset_from(robot, T_world_tool, task, q);
  const double size = size_of(error);
  if (size > most) error *= most / size;
  const bool is_wide = J.cols() >= J.rows();
  Eigen::MatrixXd square = J.transpose() * J;
  if (is_wide) square = J * J.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(square, Eigen::EigenvaluesOnly);
  const double smallest = std::max(eigen.eigenvalues()[0], 0.0);
  const double limit = damping * damping;
  if (smallest < limit) square.diagonal().array() += limit - smallest;
  if (is_wide) {
    q += J.transpose() * square.ldlt().solve(error);
  } else {
    q += square.ldlt().solve(J.transpose() * error);
  }
}

void measure(const Robot& robot, const Trajectory& motion, const CurvePiece& line, IkTask task,
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
    if (task == IkTask::kPose) plan.turn = std::max(plan.turn, error.tail<3>().norm());
  }
}

void check(const Robot& robot, const LineMove& move, double damping) {
  check_line_move(robot, move);
  check_positive("damping", damping);
  if (move.task != IkTask::kPose && move.task != IkTask::kPlace)
    throw ArgumentError("A damped line needs a goal with a place, or a place and an orientation.");
}

DampedLine follow(const Robot& robot, const LineMove& move, const CurvePiece& line,
                  double damping) {
  DampedLine plan;
  plan.length = line.travel();
  const double most = kCatchUp * line.length / kSteps;
  std::vector<double> x = {0.0};
  std::vector<Eigen::VectorXd> joints = {move.q0};
  for (int k = 1; k <= kSteps; ++k) {
    x.push_back(static_cast<double>(k) / kSteps);
    Eigen::VectorXd q = joints.back();
    const Eigen::Isometry3d T_world_tool = line.at(covered(x.back()));
    step_towards(robot, T_world_tool, move.task, damping, most, q);
    // Where nothing was left behind, what the Jacobian did not foresee.
    if (size_of(offset_from(robot, T_world_tool, move.task, q).error) < kSettled * most)
      step_towards(robot, T_world_tool, move.task, damping, most, q);
    joints.push_back(std::move(q));
  }
  std::vector<JointPath> paths;
  std::vector<double> values(joints.size());
  for (int i = 0; i < robot.n(); ++i) {
    for (std::size_t k = 0; k < joints.size(); ++k) values[k] = joints[k][i];
    paths.push_back({.segments = cubic_spline(x, values), .q_end = values.back()});
  }
  const Trajectory unit(std::move(paths), 1.0);
  measure(robot, unit, line, move.task, plan);
  plan.motion = run_unit_motion(robot, move, unit, plan.length);
  return plan;
}

}  // namespace

DampedLine plan_damped_line(const Robot& robot, const LineMove& move, double damping) {
  check(robot, move, damping);
  return follow(robot, move, straight_piece(forward(robot, move.q0), move.T_world_goal), damping);
}

std::optional<DampedLine> plan_damped_arc(const Robot& robot, const Eigen::Vector3d& p_world_via,
                                          const LineMove& move, double damping) {
  check(robot, move, damping);
  check_finite("p_world_via", p_world_via);
  const auto piece = piece_over(forward(robot, move.q0), p_world_via, move.T_world_goal);
  if (!piece) return std::nullopt;
  return follow(robot, move, *piece, damping);
}

}  // namespace armlet
