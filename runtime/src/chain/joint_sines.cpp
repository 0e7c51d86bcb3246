#include "joint_sines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {

[[gnu::cold]] void careful_joint_sines(const WalkPlan& plan, const double* q, double* sine,
                                       double* cosine) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(plan.n); ++i) {
    if (!std::isfinite(q[i])) {
      throw ArgumentError(
          fmt::format("The value of joint {} is {}; expected a finite number.", i + 1, q[i]));
    }
    const det::SinCos angle = det::sincos(plan.theta[i] + q[i] * plan.q_to_theta[i]);
    sine[i] = angle.sin;
    cosine[i] = angle.cos;
  }
}

}  // namespace armlet
