#pragma once

#include "chain/batch_arm.hpp"

// The kernels for batches of each instruction set; plain data, like batch_arm.hpp.
namespace armlet {

// What is written: the entries of axes x, y, z and origin of the tool, or the columns of the
// Jacobian.
struct BatchKernels {
  std::size_t lanes;
  BatchKernel* poses;
  BatchKernel* jacobians;
};
extern const BatchKernels kBaselineBatch, kAvx2Batch, kAvx512Batch;

}  // namespace armlet
