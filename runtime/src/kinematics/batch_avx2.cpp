#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(32)));

}  // namespace

const BatchKernels kAvx2Batch = {4, batch_poses<Numbers>, batch_jacobians<Numbers>};

}  // namespace armlet
