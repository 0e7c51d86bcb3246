#include "closed_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(64)));

}  // namespace

ClosedKernel* const kAvx512Closed = closed::closed_kernel<Numbers>;

}  // namespace armlet
