#include "armlet/kinematics/jacobian.hpp"

#include "armlet/core/error.hpp"
#include "walk.hpp"

namespace armlet {

Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J) {
  check_size("q", q.size(), robot.n());
  const Chain& chain = robot.chain();
  J.resize(6, chain.n);
  // The upper half holds the point on the axis until the tool point is known.
  Frame frame = walk(chain, q.data(), [&J](std::size_t i, const Frame& f) {
    J.col(static_cast<Eigen::Index>(i)) << f.p, f.z;
  });
  frame.step(chain.T_flange_tool);
  for (Eigen::Index i = 0; i < chain.n; ++i) {
    const Eigen::Vector3d z = J.col(i).tail<3>();
    const Eigen::Vector3d p = J.col(i).head<3>();
    if (chain.revolute[static_cast<std::size_t>(i)]) {
      J.col(i).head<3>() = z.cross(frame.p - p);
    } else {
      J.col(i) << z, Eigen::Vector3d::Zero();
    }
  }
  return frame.pose();
}

Jacobian jacobian(const Robot& robot, JointsIn q, JacobianFrame frame) {
  Jacobian J;
  const Eigen::Isometry3d T_world_tool = forward_and_jacobian(robot, q, J);
  if (frame == JacobianFrame::kWorld) return J;
  const Eigen::Matrix3d R_axes_world = frame == JacobianFrame::kTool
                                           ? T_world_tool.linear().transpose()
                                           : robot.T_world_base().linear().transpose();
  for (Eigen::Index i = 0; i < J.cols(); ++i) J.col(i) = rotate_twist(R_axes_world, J.col(i));
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
    carry_to(f.p);
    const Eigen::Vector3d motion = f.z * qd[static_cast<Eigen::Index>(i)];
    if (chain.revolute[i]) {
      wd += w.cross(motion);
      w += motion;
    } else {
      a += 2.0 * w.cross(motion);
    }
  });
  frame.step(chain.T_flange_tool);
  carry_to(frame.p);
  Vector6d result;
  result << a, wd;
  return result;
}

}  // namespace armlet
