#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(32)));

}  // namespace

const DynamicsBatchKernels kAvx2Dynamics = kDynamicsKernels<Numbers>;

}  // namespace armlet
