#pragma once

#include "armlet/chain/walk_plan.hpp"
#include "batch_arm.hpp"

namespace armlet {

static_assert(sizeof(LinkTwist) == 1 &&
              static_cast<unsigned char>(LinkTwist::kRightAngle) == kRightTwist &&
              static_cast<unsigned char>(LinkTwist::kAny) == kAnyTwist);

// What kernels of batches read; it points into the plan.
inline BatchArm batch_arm(const WalkPlan& plan) {
  return {.n = static_cast<std::size_t>(plan.n),
          .base_is_none = plan.base_is_none,
          .tool_on_axis = plan.tool_on_axis,
          .theta = plan.theta.data(),
          .q_to_theta = plan.q_to_theta.data(),
          .d = plan.d.data(),
          .q_to_d = plan.q_to_d.data(),
          .a = plan.a.data(),
          .sin_alpha = plan.sin_alpha.data(),
          .cos_alpha = plan.cos_alpha.data(),
          .base = plan.base.data(),
          .tool = plan.tool.data(),
          .has_d = plan.has_d.data(),
          .has_a = plan.has_a.data(),
          .twist = reinterpret_cast<const unsigned char*>(plan.twist.data())};
}

}  // namespace armlet
