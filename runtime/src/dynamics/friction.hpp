#pragma once

#include "dynamics_plan.hpp"

namespace armlet {

// Friction without Stribeck effect, one joint per lane or one configuration per lane.
[[gnu::always_inline]] inline double coulomb_friction(const PlanLink& link, double qd) {
  const PlanFriction& friction = link.friction;
  const double dry = qd > 0.0 ? friction.coulomb_plus : qd < 0.0 ? friction.coulomb_minus : 0.0;
  return friction.viscous * qd + dry;
}

// Friction of a joint with all its terms.
double joint_friction(const PlanLink& link, double qd);

// Adds the friction of all joints.
[[gnu::always_inline]] inline void add_friction(const DynamicsPlan& plan, const double* qd,
                                                double* tau) {
  if (plan.friction == FrictionKind::kNone) return;
  for (std::size_t i = 0; i < plan.n; ++i) {
    tau[i] += plan.friction == FrictionKind::kCoulomb ? coulomb_friction(plan.links[i], qd[i])
                                                      : joint_friction(plan.links[i], qd[i]);
  }
}

}  // namespace armlet
