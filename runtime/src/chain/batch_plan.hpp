#pragma once

#include <span>

#include "armlet/chain/instruction_set.hpp"
#include "armlet/chain/walk_plan.hpp"
#include "batch_arm.hpp"

namespace armlet {

static_assert(sizeof(LinkTwist) == 1 &&
              static_cast<unsigned char>(LinkTwist::kRightAngle) == kRightTwist &&
              static_cast<unsigned char>(LinkTwist::kAny) == kAnyTwist);

// The part of a plan that kernels of batches read; it points into the plan.
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

// Selects one of the versions of a kernel for three instruction sets: that for `set`, or for fewer
// items than lanes that of a smaller set. The results have the same bits.
template <class Kernels>
const Kernels& kernels_for(InstructionSet set, std::size_t count, const Kernels& avx512,
                           const Kernels& avx2, const Kernels& baseline) {
  if (set == InstructionSet::kAvx512 && count >= avx512.lanes) return avx512;
  if (set >= InstructionSet::kAvx2 && count >= avx2.lanes) return avx2;
  return baseline;
}

// The number of configurations of n joints in `q`.
// throws  ArgumentError if the size is not a multiple of n.
std::size_t count_configurations(std::span<const double> q, std::size_t n);

}  // namespace armlet
