#include "followers.hpp"

#include <algorithm>

namespace armlet {

Link without_mass(const Link& link) {
  Link light = link;
  light.mass = 0.0;
  light.com.setZero();
  light.inertia.setZero();
  return light;
}

Followers followers_of(const Mechanism& m, const std::vector<int>& chain,
                       const ChainDrives& drives) {
  Followers found;
  MechanismSpec spec = m.spec();
  spec.inertia_check = InertiaCheck::kPublished;
  spec.tips.clear();
  spec.actuators.clear();
  const auto n = static_cast<Eigen::Index>(drives.joints.size());
  spec.coupling.resize(m.joint_count(), n);
  spec.offset = values_at_zero(m, drives);
  for (Eigen::Index k = 0; k < n; ++k) {
    const ChainJoint& joint = drives.joints[static_cast<std::size_t>(k)];
    spec.actuators.push_back(m.actuators()[static_cast<std::size_t>(joint.actuator)]);
    spec.coupling.col(k) = m.spec().coupling.col(joint.actuator) / joint.ratio;
  }
  bool any = false;
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    const int joint = m.joint_of(static_cast<int>(i));
    const int parent = m.bodies()[i].parent;
    const bool in_chain = std::ranges::find(chain, static_cast<int>(i)) != chain.end();
    const bool by_parent = parent >= 0 && found.follows[static_cast<std::size_t>(parent)];
    const bool by_joint = joint >= 0 && !spec.coupling.row(joint).isZero(0.0);
    found.follows.push_back(!in_chain && (by_parent || by_joint));
    Link& link = spec.bodies[i].link;
    link.bodies.clear();
    link.solids.clear();
    if (!found.follows.back()) {
      link = Link{};
      continue;
    }
    const Friction& friction = link.friction;
    any = any || link.mass != 0.0 || !link.inertia.isZero(0.0) || friction.viscous != 0.0 ||
          friction.coulomb_plus != 0.0 || friction.coulomb_minus != 0.0 ||
          link.motor_inertia != 0.0;
  }
  if (any) found.mechanism = std::make_shared<const Mechanism>(std::move(spec));
  return found;
}

}  // namespace armlet
