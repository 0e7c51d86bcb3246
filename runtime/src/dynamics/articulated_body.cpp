#include <array>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "checks.hpp"
#include "friction.hpp"
#include "spatial_arm.hpp"
#include "trees/follower_forces.hpp"

namespace armlet {

JointVector articulated_body(const Robot& robot, JointsIn q, JointsIn qd, JointsIn tau) {
  check_joint_values("q", q, robot);
  check_joint_values("qd", qd, robot);
  check_joint_values("tau", tau, robot);
  if (has_followers(robot) || robot.coupling() != nullptr)
    return forward_dynamics(robot, q, qd, tau);
  const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
  const SpatialArm arm(robot, q);
  const std::size_t n = plan.n;
  std::array<Vector6d, kMaxJoints> c, U, p;
  std::array<Matrix6d, kMaxJoints> inertia = arm.inertia;
  std::array<double, kMaxJoints> D, u;
  Vector6d v = Vector6d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector6d own = arm.axis[i] * qd[static_cast<Eigen::Index>(i)];
    v += own;
    c[i] = spatial_cross(v, own);
    p[i] = spatial_cross_force(v, inertia[i] * v);
  }
  for (std::size_t i = n; i-- > 0;) {
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    U[i] = inertia[i] * arm.axis[i];
    D[i] = arm.axis[i].dot(U[i]) + plan.links[i].motor_inertia;
    // throws with the joint that moves no inertia
    if (!(D[i] > 0.0)) forward_dynamics(robot, q, qd, tau);
    u[i] = tau[k] - joint_friction(plan.links[i], qd[k]) - arm.axis[i].dot(p[i]);
    if (i == 0) break;
    const Matrix6d Ia = inertia[i] - U[i] * U[i].transpose() / D[i];
    inertia[i - 1] += Ia;
    p[i - 1] += p[i] + Ia * c[i] + U[i] * (u[i] / D[i]);
  }
  JointVector qdd(robot.n());
  Vector6d a = arm.base_acceleration;
  for (std::size_t i = 0; i < n; ++i) {
    a += c[i];
    const Eigen::Index k = static_cast<Eigen::Index>(i);
    qdd[k] = (u[i] - U[i].dot(a)) / D[i];
    a += arm.axis[i] * qdd[k];
  }
  if (!all_finite(qdd.data(), qdd.size())) refuse_result(robot, qdd, "acceleration", {});
  return qdd;
}

}  // namespace armlet
