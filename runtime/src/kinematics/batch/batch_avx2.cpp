#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(32)));

}  // namespace

const BatchKernels kAvx2Batch = kBatchKernels<Numbers>;

}  // namespace armlet
