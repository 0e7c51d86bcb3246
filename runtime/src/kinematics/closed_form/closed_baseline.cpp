#include "closed_kernels.hpp"

namespace armlet {
namespace {

using Numbers = double __attribute__((vector_size(16)));

}  // namespace

ClosedKernel* const kBaselineClosed = closed::closed_kernel<Numbers>;

}  // namespace armlet
