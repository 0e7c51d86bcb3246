#include "armlet/kinematics/jacobian.hpp"

#include "armlet/core/error.hpp"
#include "walk.hpp"

namespace armlet {

Eigen::Isometry3d forward_and_jacobian(const Robot& robot, JointsIn q, Jacobian& J) {
  check_size("q", q.size(), robot.n());
  const Chain& chain = robot.chain();
  J.resize(6, chain.n);
  std::array<Vec3, kMaxJoints> axis, point;
  Frame frame = walk(chain, q.data(), [&](std::size_t i, const Frame& f) {
    axis[i] = f.z;
    point[i] = f.p;
  });
  frame.step(chain.T_flange_tool);
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.n); ++i) {
    const Vec3 v = chain.revolute[i] ? cross(axis[i], frame.p - point[i]) : axis[i];
    const Vec3 w = chain.turns[i] * axis[i];
    J.col(static_cast<Eigen::Index>(i)) << v.xy[0], v.xy[1], v.z, w.xy[0], w.xy[1], w.z;
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
