#include "chain/quick_sines.hpp"
#include "kernels.hpp"
#include "walk_jacobian.hpp"

namespace armlet {
namespace {

template <int N>
void jacobian_kernel(const WalkPlan& plan, const double* q, double* J) {
  walk_jacobian<N>(plan, q, J);
}

template <int N>
using SinesFromBase = QuickJointSines<N, false>;

template <int N>
void quick_jacobian_kernel(const WalkPlan& plan, const double* q, double* J) {
  walk_jacobian<N, SinesFromBase>(plan, q, J);
}

template <int N>
void pose_and_jacobian_kernel(const WalkPlan& plan, const double* q, double* J,
                              double* T_world_tool) {
  walk_jacobian<N>(plan, q, J).store(T_world_tool, 1.0);
}

}  // namespace

constinit const KernelTable<JacobianKernel> kJacobianKernels =
    kernel_table<JacobianKernel>([]<int N>() { return &jacobian_kernel<N>; });

constinit const KernelTable<PoseAndJacobianKernel> kPoseAndJacobianKernels =
    kernel_table<PoseAndJacobianKernel>([]<int N>() { return &pose_and_jacobian_kernel<N>; });

constinit const KernelTable<JacobianKernel> kQuickJacobianKernels =
    kernel_table<JacobianKernel>([]<int N>() { return &quick_jacobian_kernel<N>; });

}  // namespace armlet
