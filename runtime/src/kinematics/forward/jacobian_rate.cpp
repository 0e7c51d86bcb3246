#include "armlet/core/error.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "chain/walk_out.hpp"

namespace armlet {
namespace {

Eigen::Vector3d to_eigen(const WalkAxis& v) { return {v.xy[0], v.xy[1], v.z}; }

// The axis of each joint, with its positive direction, and a point on it, collected by the
// recursion.
struct Axes {
  std::array<Eigen::Vector3d, kMaxJoints> z, p;
  Eigen::Vector3d p_tool;
  Eigen::Matrix3d R_world_tool;

  Axes(const Robot& robot, JointsIn q) {
    const WalkPlan& plan = robot.walk_plan();
    WalkFrame frame = walk_out<kAnyCount>(
        plan, q.data(),
        [&](std::size_t i, const WalkFrame& f) {
          z[i] = (plan.q_to_theta[i] + plan.q_to_d[i]) * to_eigen(f.z);
          p[i] = to_eigen(f.p);
        },
        [](std::size_t, const WalkFrame&) {});
    frame.step_tool(plan);
    p_tool = to_eigen(frame.p);
    R_world_tool << to_eigen(frame.x), to_eigen(frame.y), to_eigen(frame.z);
  }
};

void check_inputs(const Robot& robot, JointsIn q, JointsIn qd) {
  check_size("q", q.size(), robot.n());
  check_size("qd", qd.size(), robot.n());
  check_finite("qd", qd);
}

}  // namespace

Vector6d jacobian_dot_qd(const Robot& robot, JointsIn q, JointsIn qd) {
  check_inputs(robot, q, qd);
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    return jacobian_dot_qd(coupling->rows, coupling->values(q), coupling->rates(qd));
  const Axes axes(robot, q);
  // Motion of the link before each axis: angular velocity, its derivative, acceleration of p; the
  // outward recursion of Luh, Walker and Paul (1980), with qdd = 0.
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Vector3d wd = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = robot.T_world_base().translation();
  const auto carry_to = [&](const Eigen::Vector3d& p_next) {
    const Eigen::Vector3d r = p_next - p;
    a += wd.cross(r) + w.cross(w.cross(r));
    p = p_next;
  };
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    carry_to(axes.p[k]);
    const Eigen::Vector3d motion = axes.z[k] * qd[i];
    if (robot.is_revolute(i)) {
      wd += w.cross(motion);
      w += motion;
    } else {
      a += 2.0 * w.cross(motion);
    }
  }
  carry_to(axes.p_tool);
  Vector6d result;
  result << a, wd;
  return result;
}

Jacobian jacobian_rate(const Robot& robot, JointsIn q, JointsIn qd, JacobianFrame frame) {
  check_inputs(robot, q, qd);
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    return jacobian_rate(coupling->rows, coupling->values(q), coupling->rates(qd), frame) *
           coupling->E;
  const Axes axes(robot, q);
  // Velocities of the points and rates of the axes, from the base outwards.
  std::array<Eigen::Vector3d, kMaxJoints> z_rate, p_rate;
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = robot.T_world_base().translation();
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    z_rate[k] = w.cross(axes.z[k]);
    v += w.cross(axes.p[k] - p);
    p = axes.p[k];
    const Eigen::Vector3d motion = axes.z[k] * qd[i];
    (robot.is_revolute(i) ? w : v) += motion;
    p_rate[k] = v;
  }
  v += w.cross(axes.p_tool - p);
  Jacobian rate(6, robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    if (robot.is_revolute(i)) {
      rate.col(i) << z_rate[k].cross(axes.p_tool - axes.p[k]) + axes.z[k].cross(v - p_rate[k]),
          z_rate[k];
    } else {
      rate.col(i) << z_rate[k], Eigen::Vector3d::Zero();
    }
  }
  if (frame == JacobianFrame::kWorld) return rate;
  if (frame == JacobianFrame::kTool) {  // the axes rotate as well: d(R^T J) = R^T (dJ - w x J)
    const Jacobian J = jacobian(robot, q);
    for (int i = 0; i < robot.n(); ++i) {
      rate.col(i).head<3>() -= w.cross(J.col(i).head<3>());
      rate.col(i).tail<3>() -= w.cross(J.col(i).tail<3>());
    }
  }
  const bool in_tool = frame == JacobianFrame::kTool;
  const Eigen::Matrix3d R_world_axes =
      in_tool ? axes.R_world_tool : Eigen::Matrix3d(robot.T_world_base().linear());
  for (int i = 0; i < robot.n(); ++i)
    rate.col(i) = rotate_twist(R_world_axes.transpose(), rate.col(i));
  return rate;
}

}  // namespace armlet
