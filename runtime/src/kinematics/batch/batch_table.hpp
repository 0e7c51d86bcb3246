#pragma once

#include "chain/batch_arm.hpp"

// The kernels for batches of each instruction set; plain data, like batch_arm.hpp.
namespace armlet {

// Outputs: the entries of axes x, y, z and origin of the tool, or the columns of the Jacobian.
struct BatchKernels {
  std::size_t lanes;
  BatchKernel* poses;
  BatchKernel* jacobians;
};
#if defined(__x86_64__)
extern const BatchKernels kBaselineBatch, kAvx2Batch, kAvx512Batch;
#else  // other processors never use the wider ones (is_supported)
extern const BatchKernels kBaselineBatch;
inline const BatchKernels& kAvx2Batch = kBaselineBatch;
inline const BatchKernels& kAvx512Batch = kBaselineBatch;
#endif

}  // namespace armlet
