#pragma once

#include "chain/batch_arm.hpp"
#include "dynamics/dynamics_plan.hpp"

// The kernels for batches of each instruction set; plain data, like batch_arm.hpp.
namespace armlet {

struct MotionBatch {
  const BatchArm& arm;
  const DynamicsPlan& plan;
  const double *q, *qd, *qdd;
  std::size_t count;
};

// Writes the joint forces of all motions, with friction unless the plan has Stribeck friction;
// `count` is at least the number of lanes. Returns whether all of them are finite.
using MotionKernel = bool(const MotionBatch& batch, double* tau);

struct DynamicsBatchKernels {
  std::size_t lanes;
  MotionKernel* inverse;
};
#if defined(__x86_64__)
extern const DynamicsBatchKernels kBaselineDynamics, kAvx2Dynamics, kAvx512Dynamics;
#else  // other processors never use the wider ones (is_supported)
extern const DynamicsBatchKernels kBaselineDynamics;
inline const DynamicsBatchKernels& kAvx2Dynamics = kBaselineDynamics;
inline const DynamicsBatchKernels& kAvx512Dynamics = kBaselineDynamics;
#endif

}  // namespace armlet
