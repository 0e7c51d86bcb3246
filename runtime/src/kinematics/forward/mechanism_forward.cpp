#include "armlet/kinematics/mechanism_forward.hpp"

#include "model/body_inertia.hpp"

namespace armlet {

using Eigen::Isometry3d;
using Eigen::Vector3d;

std::vector<Isometry3d> body_frames(const Mechanism& mechanism, JointsIn q) {
  const Eigen::VectorXd values = mechanism.joint_values(q);
  std::vector<Isometry3d> frames;
  frames.reserve(mechanism.bodies().size());
  for (std::size_t i = 0; i < mechanism.bodies().size(); ++i) {
    const Body& body = mechanism.bodies()[i];
    const int joint = mechanism.joint_of(static_cast<int>(i));
    Isometry3d T = body.parent >= 0
                       ? frames[static_cast<std::size_t>(body.parent)] * body.T_parent_joint
                       : body.T_parent_joint;
    if (joint >= 0) T = T * joint_motion(body, values[joint]);
    frames.push_back(T);
  }
  return frames;
}

Isometry3d tip_pose(const Mechanism& mechanism, JointsIn q, const Tip& tip) {
  if (tip.body < 0) return tip.T_body_tip;
  return body_frames(mechanism, q)[static_cast<std::size_t>(tip.body)] * tip.T_body_tip;
}

Matrix6Xd tip_jacobian(const Mechanism& mechanism, JointsIn q, const Tip& tip) {
  Matrix6Xd J = Matrix6Xd::Zero(6, mechanism.joint_count());
  if (tip.body >= 0) {
    const std::vector<Isometry3d> frames = body_frames(mechanism, q);
    const Vector3d p = frames[static_cast<std::size_t>(tip.body)] * tip.T_body_tip.translation();
    for (int i = tip.body; i >= 0; i = mechanism.bodies()[static_cast<std::size_t>(i)].parent) {
      const int joint = mechanism.joint_of(i);
      if (joint < 0) continue;
      const Body& body = mechanism.bodies()[static_cast<std::size_t>(i)];
      const Isometry3d& T = frames[static_cast<std::size_t>(i)];
      const Vector3d axis = T.linear() * body.axis;
      if (body.joint == BodyJoint::kRevolute) {
        J.col(joint) << axis.cross(p - T.translation()), axis;
      } else {
        J.col(joint) << axis, Vector3d::Zero();
      }
    }
  }
  return J * mechanism.spec().coupling;
}

}  // namespace armlet
