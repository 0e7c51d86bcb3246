#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(16)));

}  // namespace

const DynamicsBatchKernels kBaselineDynamics = kDynamicsKernels<Numbers>;

}  // namespace armlet
