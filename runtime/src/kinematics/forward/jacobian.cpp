#include "armlet/kinematics/jacobian.hpp"

#include "armlet/core/error.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

// Rotates all columns.
void rotate_twists(const Eigen::Matrix3d& R, Jacobian& J) {
  for (Eigen::Index i = 0; i < J.cols(); ++i) J.col(i) = rotate_twist(R, J.col(i));
}

}  // namespace

Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J) {
  check_size("q", q.size(), robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    Jacobian of_rows;
    const Eigen::Isometry3d T = forward_and_jacobian(coupling->rows, coupling->values(q), of_rows);
    J = of_rows * coupling->E;
    return T;
  }
  J.resize(6, robot.n());
  Eigen::Isometry3d T_world_tool;
  kernel_for(kPoseAndJacobianKernels, robot.n())(robot.walk_plan(), q.data(), J.data(),
                                                 T_world_tool.data());
  return T_world_tool;
}

Jacobian jacobian(const Robot& robot, JointsIn q, JacobianFrame frame) {
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    check_size("q", q.size(), robot.n());
    return jacobian(coupling->rows, coupling->values(q), frame) * coupling->E;
  }
  Jacobian J;
  if (frame == JacobianFrame::kTool) {
    const Eigen::Isometry3d T_world_tool = forward_and_jacobian(robot, q, J);
    rotate_twists(T_world_tool.linear().transpose(), J);
    return J;
  }
  check_size("q", q.size(), robot.n());
  J.resize(6, robot.n());
  kernel_for(kJacobianKernels, robot.n())(robot.walk_plan(), q.data(), J.data());
  if (frame == JacobianFrame::kBase) rotate_twists(robot.T_world_base().linear().transpose(), J);
  return J;
}

}  // namespace armlet
