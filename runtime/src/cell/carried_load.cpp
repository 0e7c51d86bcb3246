#include "cell/carried_load.hpp"

#include "armlet/kinematics/jacobian.hpp"

namespace armlet {

namespace {

// The carried objects for which `counts` is true, as one body in the frame that carries them.
template <class Counts>
Payload sum_of(const World& world, int carrier, Counts&& counts) {
  Payload load;
  for (const std::size_t i : world.carried()) {
    const auto& attachment = world.attachment_of(i);
    if (attachment->carrier != carrier || !counts(*attachment)) continue;
    const Object& object = world.object(i);
    const Eigen::Matrix3d R = attachment->T_carrier_obj.linear();
    load = together(load, {.mass = object.mass,
                           .com = attachment->T_carrier_obj * center_of_mass(object),
                           .inertia = R * inertia(object) * R.transpose()});
  }
  return load;
}

}  // namespace

Payload held_load(const World& world, int carrier) {
  return sum_of(world, carrier, [](const Attachment& each) { return !each.mounted; });
}

std::shared_ptr<const Robot> loaded_arm(const std::shared_ptr<const Robot>& model,
                                        const World& world, int carrier) {
  std::shared_ptr<const Robot> loaded = model;
  const auto at_flange = [&](const Attachment& each) {
    return each.frame == kFlange || each.frame == model->rows();
  };
  const Payload carried = sum_of(world, carrier, at_flange);
  if (carried.mass != 0.0) {
    loaded =
        std::make_shared<const Robot>(model->with_payload(together(model->payload(), carried)));
  }
  if (!world.has_mounted(carrier)) return loaded;
  for (int frame = 1; frame < model->rows(); ++frame) {
    const Payload mounted =
        sum_of(world, carrier, [&](const Attachment& each) { return each.frame == frame; });
    if (mounted.mass == 0.0) continue;
    Link link = model->link(frame - 1);
    const Payload sum =
        together({.mass = link.mass, .com = link.com, .inertia = link.inertia}, mounted);
    link.mass = sum.mass;
    link.com = sum.com;
    link.inertia = sum.inertia;
    loaded = std::make_shared<const Robot>(loaded->with_link(frame - 1, link));
  }
  return loaded;
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
