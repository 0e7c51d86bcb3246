#include "friction.hpp"

#include "armlet/math/det_math.hpp"

namespace armlet {

double joint_friction(const PlanLink& link, double qd) {
  const PlanFriction& friction = link.friction;
  const double sliding = coulomb_friction(link, qd);
  if (friction.stribeck_rate == 0.0 || qd == 0.0) return sliding;
  const double ratio = qd * friction.stribeck_rate;
  const double extra = qd > 0.0 ? friction.static_extra_plus : friction.static_extra_minus;
  return sliding + extra * det::exp(-ratio * ratio);
}

}  // namespace armlet
