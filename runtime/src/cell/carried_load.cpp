#include "cell/carried_load.hpp"

#include "armlet/kinematics/jacobian.hpp"

namespace armlet {

Payload carried_load(const World& world, int carrier) {
  Payload load;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const auto& attachment = world.attachment_of(i);
    if (!attachment || attachment->carrier != carrier) continue;
    const Object& object = world.object(i);
    const Eigen::Matrix3d R = attachment->T_carrier_obj.linear();
    load = together(load, {.mass = object.mass,
                           .com = attachment->T_carrier_obj * center_of_mass(object),
                           .inertia = R * inertia(object) * R.transpose()});
  }
  return load;
}

Vector6d load_wrench(const Robot& robot, const Payload& load,
                     const Eigen::Isometry3d& T_world_flange, const Eigen::VectorXd& q,
                     const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd) {
  Jacobian J(6, robot.n());
  const Eigen::Isometry3d T_world_tool = forward_and_jacobian(robot, q, J);
  const Vector6d acceleration = J * qdd + jacobian_dot_qd(robot, q, qd);
  const Eigen::Vector3d w = (J * qd).tail<3>();
  const Eigen::Vector3d a = acceleration.head<3>(), alpha = acceleration.tail<3>();
  const Eigen::Vector3d r = T_world_flange * load.com - T_world_tool.translation();
  const Eigen::Vector3d a_com = a + alpha.cross(r) + w.cross(w.cross(r));
  const Eigen::Matrix3d I =
      T_world_flange.linear() * load.inertia * T_world_flange.linear().transpose();
  const Eigen::Vector3d f = load.mass * (robot.gravity() - a_com);
  Vector6d wrench;
  wrench << f, r.cross(f) - I * alpha - w.cross(I * w);
  return wrench;
}

}  // namespace armlet
