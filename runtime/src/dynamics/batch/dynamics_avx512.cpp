#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(64)));

}  // namespace

const DynamicsBatchKernels kAvx512Dynamics = kDynamicsKernels<Numbers>;

}  // namespace armlet
