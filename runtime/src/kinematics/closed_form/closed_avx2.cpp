#include "closed_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(32)));

}  // namespace

ClosedKernel* const kAvx2Closed = closed::closed_kernel<Numbers>;

}  // namespace armlet
