#pragma once

#include "armlet/model/walk_plan.hpp"
#include "batch_arm.hpp"

namespace armlet {

// The flags that a plan does not hold as such.
struct BatchFlags {
  std::array<bool, kMaxJoints + 1> right{}, any{}, slides{}, plain{};

  explicit BatchFlags(const WalkPlan& plan);
};

// What kernels of batches read; it points into both.
BatchArm batch_arm(const WalkPlan& plan, const BatchFlags& flags);

}  // namespace armlet
