#include "armlet/dynamics/forward_dynamics.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "armlet/dynamics/inverse_dynamics.hpp"
#include "checks.hpp"
#include "coupled.hpp"
#include "friction.hpp"
#include "trees/follower_forces.hpp"

namespace armlet {

[[noreturn, gnu::cold]] static void refuse_massless(const Robot& robot, int joint) {
  throw ArgumentError(fmt::format(
      "The inertia matrix of robot `{}` is not positive definite: nothing resists joint {}, so no "
      "force determines its acceleration. Expected a mass that it moves, or a motorInertia.",
      robot.name(), joint + 1));
}

JointMatrix mass_matrix(const Robot& robot, JointsIn q) {
  check_joint_count("q", q, robot);
  JointMatrix M(robot.n(), robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    M = for_joints(*coupling, mass_matrix(coupling->rows, coupling->values(q)));
  } else {
    const DynamicsInput in = input_of(robot, q.data());
    kernel_for(kMassKernels, in.plan)(in, M.data());
  }
  if (has_followers(robot)) [[unlikely]]
    add_follower_inertia(robot, q, M);
  return M;
}

// From M qdd = tau - friction - bias: the recursions support neither links outside of the chain nor
// mimic joints.
static JointVector accelerations_by_matrix(const Robot& robot, JointsIn q, JointsIn qd,
                                           JointsIn tau) {
  check_joint_values("qd", qd, robot);
  check_joint_values("tau", tau, robot);
  const JointMatrix M = mass_matrix(robot, q);
  const Eigen::LLT<JointMatrix> factors(M);
  if (factors.info() != Eigen::Success) {
    Eigen::Index least = 0;
    M.diagonal().minCoeff(&least);
    refuse_massless(robot, static_cast<int>(least));
  }
  JointVector qdd = factors.solve(tau - friction_forces(robot, qd) - bias_forces(robot, q, qd));
  if (!all_finite(qdd.data(), qdd.size())) refuse_result(robot, qdd, "acceleration", {});
  return qdd;
}

JointVector forward_dynamics(const Robot& robot, JointsIn q, JointsIn qd, JointsIn tau) {
  check_joint_count("q", q, robot);
  check_joint_count("qd", qd, robot);
  check_joint_count("tau", tau, robot);
  if (has_followers(robot) || robot.coupling() != nullptr) [[unlikely]]
    return accelerations_by_matrix(robot, q, qd, tau);
  const DynamicsInput in = input_of(robot, q.data(), qd.data());
  JointVector qdd = tau;
  if (in.plan.friction != FrictionKind::kNone) {
    JointVector friction = JointVector::Zero(robot.n());
    add_friction(in.plan, qd.data(), friction.data());
    qdd -= friction;
  }
  const int solved = kernel_for(kForwardKernels, in.plan)(in, qdd.data());
  if (solved < robot.n() || !all_finite(qdd.data(), qdd.size())) [[unlikely]] {
    check_joint_values("qd", qd, robot);
    check_joint_values("tau", tau, robot);
    if (solved < robot.n()) refuse_massless(robot, solved);
    refuse_result(robot, qdd, "acceleration", {});
  }
  return qdd;
}

Result<Matrix6d> operational_inertia(const Eigen::MatrixXd& M, const Eigen::MatrixXd& J) {
  check_size("rows of J", J.rows(), 6);
  check_size("columns of M", M.cols(), M.rows());
  check_size("columns of J", J.cols(), M.rows());
  check_finite("M", M);
  check_finite("J", J);
  const Eigen::LLT<Eigen::MatrixXd> factors(M);
  if (factors.info() != Eigen::Success) {
    throw ArgumentError("`M` is not positive definite; expected the inertia matrix of an arm.");
  }
  // With L^-1 J' = Q R the inverse is R' R, whose rank is judged on R.
  const Eigen::MatrixXd root = factors.matrixL().solve(J.transpose());
  const Matrix6d mobility = root.transpose() * root;
  const Eigen::FullPivLU<Matrix6d> lu(mobility);
  if (!lu.isInvertible() || lu.rcond() < 1e-12) {
    return Error{"singular", fmt::format("The tool of this arm cannot accelerate in all six "
                                         "directions here: the Jacobian has rank {}",
                                         Eigen::FullPivLU<Eigen::MatrixXd>(J).rank())};
  }
  const Matrix6d inertia = lu.inverse();
  return Matrix6d(0.5 * (inertia + inertia.transpose()));
}

}  // namespace armlet
