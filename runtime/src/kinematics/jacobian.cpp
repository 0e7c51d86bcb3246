#include "armlet/kinematics/jacobian.hpp"

#include "armlet/core/error.hpp"
#include "kernels.hpp"
#include "walk.hpp"

namespace armlet {
namespace {

// The same columns in other axes.
void turn_twists(const Eigen::Matrix3d& R, Jacobian& J) {
  for (Eigen::Index i = 0; i < J.cols(); ++i) J.col(i) = rotate_twist(R, J.col(i));
}

}  // namespace

Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J) {
  check_size("q", q.size(), robot.n());
  J.resize(6, robot.n());
  Eigen::Isometry3d T_world_tool;
  kernel_for(kPoseAndJacobianKernels, robot.n())(robot.walk_plan(), q.data(), J.data(),
                                                 T_world_tool.data());
  return T_world_tool;
}

Jacobian jacobian(const Robot& robot, JointsIn q, JacobianFrame frame) {
  Jacobian J;
  if (frame == JacobianFrame::kTool) {
    const Eigen::Isometry3d T_world_tool = forward_and_jacobian(robot, q, J);
    turn_twists(T_world_tool.linear().transpose(), J);
    return J;
  }
  check_size("q", q.size(), robot.n());
  J.resize(6, robot.n());
  kernel_for(kJacobianKernels, robot.n())(robot.walk_plan(), q.data(), J.data());
  if (frame == JacobianFrame::kBase) turn_twists(robot.T_world_base().linear().transpose(), J);
  return J;
}

Vector6d jacobian_dot_qd(const Robot& robot, JointsIn q, JointsIn qd) {
  check_size("q", q.size(), robot.n());
  check_size("qd", qd.size(), robot.n());
  const Chain& chain = robot.chain();
  // Motion of the link before each axis: angular velocity, its derivative, acceleration of p.
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Vector3d wd = Eigen::Vector3d::Zero();
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = chain.T_world_base.translation();
  const auto carry_to = [&](const Eigen::Vector3d& p_next) {
    const Eigen::Vector3d r = p_next - p;
    a += wd.cross(r) + w.cross(w.cross(r));
    p = p_next;
  };
  Frame frame = walk(chain, q.data(), [&](std::size_t i, const Frame& f) {
    carry_to(f.p.to_eigen());
    const Eigen::Vector3d motion = f.z.to_eigen() * qd[static_cast<Eigen::Index>(i)];
    if (chain.revolute[i]) {
      wd += w.cross(motion);
      w += motion;
    } else {
      a += 2.0 * w.cross(motion);
    }
  });
  frame.step(chain.T_flange_tool);
  carry_to(frame.p.to_eigen());
  Vector6d result;
  result << a, wd;
  return result;
}

}  // namespace armlet
