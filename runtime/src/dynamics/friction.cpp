#include "friction.hpp"

#include "armlet/math/det_math.hpp"

namespace armlet {

double joint_friction(const PlanLink& link, double qd) {
  const double sliding = coulomb_friction(link, qd);
  if (link.stribeck_rate == 0.0 || qd == 0.0) return sliding;
  const double ratio = qd * link.stribeck_rate;
  const double extra = qd > 0.0 ? link.static_extra_plus : link.static_extra_minus;
  return sliding + extra * det::exp(-ratio * ratio);
}

}  // namespace armlet
