#include "batch_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(64)));

}  // namespace

const BatchKernels kAvx512Batch = kBatchKernels<Numbers>;

}  // namespace armlet
