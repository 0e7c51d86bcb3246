#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"
#include "batch_arm.hpp"
#include "math/det_quick_lanes.hpp"

namespace armlet {

// One configuration after the other, so that the reported error does not depend on the vector
// width.
[[gnu::cold]] void careful_batch_sines(const BatchArm& arm, const double* q, std::size_t count,
                                       const BlockSines& block) {
  for (std::size_t lane = 0; lane < block.lanes; ++lane) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      const std::size_t k = block.k + lane;
      const double value = q[i * count + k];
      if (!std::isfinite(value)) {
        throw ArgumentError(fmt::format(
            "The value of joint {} in configuration {} is {}; expected a finite number.", i + 1,
            k + 1, value));
      }
      const double angle = arm.theta[i] + value * arm.q_to_theta[i];
      if (!det::is_too_large(angle)) continue;
      const det::SinCos exact = det::sincos(angle);
      block.sines[i * block.stride + lane] = exact.sin;
      block.cosines[i * block.stride + lane] = exact.cos;
    }
  }
}

}  // namespace armlet
