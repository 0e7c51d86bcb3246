#include "armlet/kinematics/null_space.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRank = 1e-9;        // of the largest singular value
constexpr double kLeast = 1e-300;     // of a largest singular value
constexpr double kLargestStep = 0.1;  // rad or m, of one step towards a better posture
constexpr double kSmallestStep = 1e-7;
constexpr double kDrift = 1e-9;  // m and rad by which a posture may move the tool

MatrixXd selected(const MatrixXd& all, const TaskRows& rows) {
  MatrixXd out(std::count(rows.counts.begin(), rows.counts.end(), true), all.cols());
  Eigen::Index next = 0;
  for (std::size_t r = 0; r < 6; ++r) {
    if (rows.counts[r]) out.row(next++) = all.row(static_cast<Eigen::Index>(r));
  }
  return out;
}

MatrixXd task_jacobian(const Robot& robot, JointsIn q, const TaskRows& rows) {
  return selected(jacobian(robot, q, rows.axes), rows);
}

// Drift of the tool from the pose, in the rows of the task.
VectorXd task_error(const Robot& robot, const Eigen::Isometry3d& T_world_tool, JointsIn q,
                    const TaskRows& rows) {
  const Eigen::Isometry3d T = forward(robot, q);
  Vector6d e;
  e << T_world_tool.translation() - T.translation(),
      rotation_log(T_world_tool.linear() * T.linear().transpose());
  if (rows.axes == JacobianFrame::kTool) e = rotate_twist(T.linear().transpose(), e);
  if (rows.axes == JacobianFrame::kBase)
    e = rotate_twist(robot.T_world_base().linear().transpose(), e);
  return selected(e, rows);
}

// The part of J = U diag(s) V^T with singular values that are not zero within rounding.
SvdParts decompose(const MatrixXd& J) {
  SvdParts svd = singular_values(J);
  const Eigen::Index rank =
      svd.s.size() == 0 ? 0 : (svd.s.array() >= kRank * std::max(svd.s[0], kLeast)).count();
  return {svd.U.leftCols(rank), svd.s.head(rank), svd.V.leftCols(rank)};
}

// The smallest x that minimises |J x - e|.
VectorXd solve_least(const MatrixXd& J, const VectorXd& e) {
  const SvdParts svd = decompose(J);
  return svd.V * (svd.U.transpose() * e).cwiseQuotient(svd.s);
}

// I - V_r V_r^T
MatrixXd projector(const MatrixXd& J) {
  const MatrixXd V = decompose(J).V;
  return MatrixXd::Identity(J.cols(), J.cols()) - V * V.transpose();
}

// The step, corrected so that the tool does not move. Empty if the correction fails, or ends beyond
// a limit.
VectorXd kept_in_place(const Robot& robot, const Eigen::Isometry3d& T_world_tool, VectorXd q,
                       const std::vector<bool>& held, const TaskRows& rows) {
  for (int round = 0; round < 5; ++round) {
    const VectorXd e = task_error(robot, T_world_tool, q, rows);
    if (e.size() == 0 || e.cwiseAbs().maxCoeff() < 1e-12) break;
    MatrixXd J = task_jacobian(robot, q, rows);
    for (int i = 0; i < robot.n(); ++i) {
      if (held[static_cast<std::size_t>(i)]) J.col(i).setZero();
    }
    q += solve_least(J, e);
  }
  const VectorXd e = task_error(robot, T_world_tool, q, rows);
  const bool moved = e.size() > 0 && e.cwiseAbs().maxCoeff() > kDrift;
  return moved || !within_limits(robot, q, 0.0) ? VectorXd() : q;
}

// The step up to the first limit; the joint that reaches it is held there.
VectorXd stepped(const Robot& robot, const VectorXd& q, const VectorXd& step,
                 std::vector<bool>& held) {
  double share = 1.0;
  Eigen::Index first = -1;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (step[i] == 0.0) continue;
    const double limit = step[i] > 0.0 ? robot.upper()[i] : robot.lower()[i];
    const double to_limit = (limit - q[i]) / step[i];
    if (!(to_limit < share)) continue;
    share = std::max(to_limit, 0.0);
    first = i;
  }
  VectorXd next = q + share * step;
  if (first >= 0) {
    next[first] = step[first] > 0.0 ? robot.upper()[first] : robot.lower()[first];
    held[static_cast<std::size_t>(first)] = true;
  }
  return next;
}

}  // namespace

MatrixXd null_space_projector(const Robot& robot, JointsIn q, const TaskRows& rows) {
  return projector(task_jacobian(robot, q, rows));
}

VectorXd self_motion_step(const Robot& robot, const Eigen::Isometry3d& T_world_tool, JointsIn q,
                          JointsIn qd, double dt, const TaskRows& rows) {
  check_size("qd", qd.size(), robot.n());
  VectorXd next = q + dt * (null_space_projector(robot, q, rows) * qd);
  next +=
      solve_least(task_jacobian(robot, next, rows), task_error(robot, T_world_tool, next, rows));
  return next;
}

VectorXd improve_posture(const Robot& robot, JointsIn q_start, const PostureGoal& goal,
                         const TaskRows& rows, int steps) {
  check_size("q", q_start.size(), robot.n());
  const Eigen::Isometry3d T_world_tool = forward(robot, q_start);
  VectorXd q = q_start;
  double value = posture_value(robot, q, goal);
  double length = kLargestStep;
  for (int step = 0; step < steps && length > kSmallestStep; ++step) {
    // Joints at a limit that the step would push outwards stay there.
    std::vector<bool> held(static_cast<std::size_t>(robot.n()), false);
    MatrixXd J = task_jacobian(robot, q, rows);
    VectorXd gradient = posture_gradient(robot, q, goal);
    VectorXd direction;
    for (bool again = true; again;) {
      again = false;
      direction = projector(J) * gradient;
      for (int i = 0; i < robot.n(); ++i) {
        const bool outwards = (direction[i] > 0.0 && q[i] >= robot.upper()[i] - kDrift) ||
                              (direction[i] < 0.0 && q[i] <= robot.lower()[i] + kDrift);
        if (!outwards || held[static_cast<std::size_t>(i)]) continue;
        held[static_cast<std::size_t>(i)] = again = true;
        J.col(i).setZero();
        gradient[i] = 0.0;
      }
    }
    const double largest = direction.cwiseAbs().maxCoeff();
    if (largest < 1e-9) break;
    const VectorXd tried = stepped(robot, q, direction * (length / largest), held);
    const VectorXd next = kept_in_place(robot, T_world_tool, tried, held, rows);
    const double next_value = next.size() > 0 ? posture_value(robot, next, goal) : -INFINITY;
    if (next_value > value) {
      q = next;
      value = next_value;
      length = std::min(1.5 * length, kLargestStep);
    } else {
      length *= 0.5;
    }
  }
  return q;
}

BoundedSpeeds bounded_joint_speeds(const Robot& robot, JointsIn q, const Vector6d& twist,
                                   JointsIn qd_wished, JointsIn lower, JointsIn upper,
                                   const TaskRows& rows) {
  check_size("qd_wished", qd_wished.size(), robot.n());
  check_size("lower", lower.size(), robot.n());
  check_size("upper", upper.size(), robot.n());
  const MatrixXd J = task_jacobian(robot, q, rows);
  const VectorXd v = selected(twist, rows);
  MatrixXd J_free = J;
  VectorXd start = qd_wished;
  BoundedSpeeds out;
  for (int round = 0; round <= robot.n(); ++round) {
    out.qd = start + solve_least(J_free, v - J * start);
    int worst = -1;
    double excess = 1e-12;
    for (int i = 0; i < robot.n(); ++i) {
      const double over = std::max(out.qd[i] - upper[i], lower[i] - out.qd[i]);
      if (over > excess) {
        excess = over;
        worst = i;
      }
    }
    if (worst < 0) break;
    start[worst] = std::clamp(out.qd[worst], lower[worst], upper[worst]);
    J_free.col(worst).setZero();
    out.saturated.push_back(worst);
  }
  out.qd = out.qd.cwiseMax(lower).cwiseMin(upper);
  out.reached = v.size() == 0 || (J * out.qd - v).cwiseAbs().maxCoeff() < 1e-9;
  return out;
}

}  // namespace armlet
