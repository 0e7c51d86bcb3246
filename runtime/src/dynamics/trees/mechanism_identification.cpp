#include <cmath>
#include <utility>

#include "armlet/dynamics/identification.hpp"
#include "armlet/math/check_finite.hpp"
#include "dynamics/identification/link_parameters.hpp"
#include "model/body_inertia.hpp"
#include "spatial_tree.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

}  // namespace

VectorXd dynamic_parameters(const Mechanism& mechanism) {
  const std::vector<Body>& bodies = mechanism.bodies();
  VectorXd p = VectorXd::Zero(kLinkParameters * static_cast<Index>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Link& link = bodies[i].link;
    const Index first = kLinkParameters * static_cast<Index>(i);
    p.segment<kMassParameters>(first) =
        mass_parameters(moments_of(link.mass, link.com, link.inertia));
    if (mechanism.joint_of(static_cast<int>(i)) < 0) continue;
    const double gear = std::abs(link.gear);
    p.segment<4>(first + kMassParameters) << squared_gear(link) * link.motor_inertia,
        squared_gear(link) * link.friction.viscous, gear * link.friction.coulomb_plus,
        gear * link.friction.coulomb_minus;
  }
  return p;
}

MatrixXd dynamics_regressor(const Mechanism& mechanism, const MechanismMotion& motion,
                            const Vector3d& gravity) {
  check_motion(mechanism, motion, gravity);
  const MatrixXd& C = mechanism.spec().coupling;
  const VectorXd rates = C * motion.qd, accelerations = C * motion.qdd;
  const SpatialTree tree(mechanism, motion.q);
  const std::vector<BodyMotion> motions = tree.motions(rates, accelerations, gravity);
  const std::vector<Body>& bodies = mechanism.bodies();
  MatrixXd joints =
      MatrixXd::Zero(mechanism.joint_count(), kLinkParameters * static_cast<Index>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [v, a] = motions[i];
    const Index first = kLinkParameters * static_cast<Index>(i);
    for (int k = 0; k < kMassParameters; ++k) {
      const Matrix6d I = spatial_inertia(unit_body(k).seen_from(tree.frames()[i]));
      const Vector6d force = I * a + spatial_cross_force(v, I * v);
      for (int on = static_cast<int>(i); on >= 0;
           on = bodies[static_cast<std::size_t>(on)].parent) {
        const int joint = mechanism.joint_of(on);
        if (joint >= 0)
          joints(joint, first + k) = tree.axes()[static_cast<std::size_t>(on)].dot(force);
      }
    }
    const int joint = mechanism.joint_of(static_cast<int>(i));
    if (joint < 0) continue;
    joints(joint, first + kMassParameters) = accelerations[joint];
    joints(joint, first + kMassParameters + 1) = rates[joint];
    if (rates[joint] != 0.0)
      joints(joint, first + kMassParameters + (rates[joint] > 0.0 ? 2 : 3)) = 1.0;
  }
  MatrixXd Y = C.transpose() * joints;
  check_finite("regressor", Y);
  return Y;
}

Mechanism with_payload(const Mechanism& mechanism, std::string_view tip, const Payload& payload) {
  const Tip& at = mechanism.tip(tip);
  MechanismSpec spec = mechanism.spec();
  const Link body{.mass = payload.mass, .com = payload.com, .inertia = payload.inertia};
  add_body(spec.bodies[static_cast<std::size_t>(at.body)].link, moved(body, at.T_body_tip));
  return Mechanism(std::move(spec));
}

}  // namespace armlet
