#include "armlet/dynamics/inverse_dynamics.hpp"

#include "chain/walk_out.hpp"
#include "checks.hpp"
#include "coupled.hpp"
#include "friction.hpp"
#include "trees/follower_forces.hpp"

namespace armlet {

JointVector inverse_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd) {
  check_joint_count("q", q, robot);
  check_joint_count("qd", qd, robot);
  check_joint_count("qdd", qdd, robot);
  JointVector tau(robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    tau = for_joints(*coupling, inverse_dynamics(coupling->rows, coupling->values(q),
                                                 coupling->rates(qd), coupling->rates(qdd)));
  } else {
    const DynamicsInput in = input_of(robot, q.data(), qd.data(), qdd.data());
    kernel_for(kInverseKernels, in.plan)(in, tau.data());
    add_friction(in.plan, qd.data(), tau.data());
  }
  if (has_followers(robot)) [[unlikely]] {
    add_follower_forces(robot, q, qd, qdd, true, tau);
    add_follower_friction(robot, qd, tau);
  }
  if (!all_finite(tau.data(), tau.size())) [[unlikely]] {
    refuse_result(robot, tau, "force", {{"q", q}, {"qd", qd}, {"qdd", qdd}});
  }
  return tau;
}

JointVector inverse_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn qdd,
                             const Vector6d& wrench) {
  JointVector tau = inverse_dynamics(robot, q, qd, qdd);
  tau -= wrench_forces(robot, q, wrench);
  if (!all_finite(tau.data(), tau.size())) refuse_result(robot, tau, "force", {});
  return tau;
}

JointVector bias_forces(const Robot& robot, JointsIn q, JointsIn qd) {
  check_joint_count("q", q, robot);
  check_joint_count("qd", qd, robot);
  JointVector tau(robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    tau = for_joints(*coupling,
                     bias_forces(coupling->rows, coupling->values(q), coupling->rates(qd)));
  } else {
    const DynamicsInput in = input_of(robot, q.data(), qd.data());
    kernel_for(kBiasKernels, in.plan)(in, tau.data());
  }
  if (has_followers(robot)) [[unlikely]]
    add_follower_forces(robot, q, qd, {}, true, tau);
  if (!all_finite(tau.data(), tau.size())) [[unlikely]] {
    refuse_result(robot, tau, "force", {{"q", q}, {"qd", qd}});
  }
  return tau;
}

JointVector gravity_forces(const Robot& robot, JointsIn q) {
  check_joint_count("q", q, robot);
  JointVector tau(robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    tau = for_joints(*coupling, gravity_forces(coupling->rows, coupling->values(q)));
  } else {
    const DynamicsInput in = input_of(robot, q.data());
    kernel_for(kGravityKernels, in.plan)(in, tau.data());
  }
  if (has_followers(robot)) [[unlikely]]
    add_follower_forces(robot, q, {}, {}, true, tau);
  if (!all_finite(tau.data(), tau.size())) [[unlikely]] {
    refuse_result(robot, tau, "force", {{"q", q}});
  }
  return tau;
}

JointVector coriolis_forces(const Robot& robot, JointsIn q, JointsIn qd) {
  check_joint_count("q", q, robot);
  check_joint_count("qd", qd, robot);
  JointVector tau(robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    tau = for_joints(*coupling,
                     coriolis_forces(coupling->rows, coupling->values(q), coupling->rates(qd)));
  } else {
    constexpr double kWeightless[3] = {};
    const DynamicsPlan& plan = robot.derived<RobotDynamics>().plan;
    kernel_for(kBiasKernels, plan)(
        {robot.walk_plan(), plan, q.data(), qd.data(), nullptr, kWeightless}, tau.data());
  }
  if (has_followers(robot)) [[unlikely]]
    add_follower_forces(robot, q, qd, {}, false, tau);
  if (!all_finite(tau.data(), tau.size())) [[unlikely]] {
    refuse_result(robot, tau, "force", {{"q", q}, {"qd", qd}});
  }
  return tau;
}

JointVector friction_forces(const Robot& robot, JointsIn qd) {
  check_joint_values("qd", qd, robot);
  JointVector tau = JointVector::Zero(robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    tau = for_joints(*coupling, friction_forces(coupling->rows, coupling->rates(qd)));
  else
    add_friction(robot.derived<RobotDynamics>().plan, qd.data(), tau.data());
  if (has_followers(robot)) add_follower_friction(robot, qd, tau);
  if (!all_finite(tau.data(), tau.size())) refuse_result(robot, tau, "friction", {});
  return tau;
}

JointVector wrench_forces(const Robot& robot, JointsIn q, const Vector6d& wrench) {
  check_joint_count("q", q, robot);
  check_finite("wrench", wrench);
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    return for_joints(*coupling, wrench_forces(coupling->rows, coupling->values(q), wrench));
  const WalkPlan& plan = robot.walk_plan();
  const auto vector_of = [](const WalkAxis& v) { return Eigen::Vector3d(v.xy[0], v.xy[1], v.z); };
  std::array<Eigen::Vector3d, kMaxJoints> axis, point;
  WalkFrame frame = walk_out<kAnyCount>(
      plan, q.data(),
      [&](std::size_t i, const WalkFrame& at) {
        axis[i] = vector_of(at.z);
        point[i] = vector_of(at.p);
      },
      [](std::size_t, const WalkFrame&) {});
  frame.step_tool(plan);
  const Eigen::Vector3d tool = vector_of(frame.p), f = wrench.head<3>(), m = wrench.tail<3>();
  JointVector tau(robot.n());
  for (Eigen::Index j = 0; j < tau.size(); ++j) {
    const std::size_t i = static_cast<std::size_t>(j);
    const double turning = axis[i].dot(m + (tool - point[i]).cross(f));
    tau[j] = plan.q_to_theta[i] * turning + plan.q_to_d[i] * axis[i].dot(f);
  }
  return tau;
}

}  // namespace armlet
