#include "kernels.hpp"
#include "quick_turns.hpp"
#include "walk_jacobian.hpp"

namespace armlet {
namespace {

template <int N>
void jacobian_kernel(const WalkPlan& plan, const double* q, double* J) {
  walk_jacobian<N>(plan, q, J);
}

template <int N>
using TurnsFromBase = QuickTurns<N, false>;

template <int N>
void quick_jacobian_kernel(const WalkPlan& plan, const double* q, double* J) {
  walk_jacobian<N, TurnsFromBase>(plan, q, J);
}

template <int N>
void pose_and_jacobian_kernel(const WalkPlan& plan, const double* q, double* J,
                              double* T_world_tool) {
  walk_jacobian<N>(plan, q, J).store(T_world_tool, 1.0);
}

}  // namespace

const KernelTable<JacobianKernel> kJacobianKernels = {
    jacobian_kernel<kAnyCount>, jacobian_kernel<1>, jacobian_kernel<2>,
    jacobian_kernel<3>,         jacobian_kernel<4>, jacobian_kernel<5>,
    jacobian_kernel<6>,         jacobian_kernel<7>, jacobian_kernel<8>};

const KernelTable<PoseAndJacobianKernel> kPoseAndJacobianKernels = {
    pose_and_jacobian_kernel<kAnyCount>, pose_and_jacobian_kernel<1>, pose_and_jacobian_kernel<2>,
    pose_and_jacobian_kernel<3>,         pose_and_jacobian_kernel<4>, pose_and_jacobian_kernel<5>,
    pose_and_jacobian_kernel<6>,         pose_and_jacobian_kernel<7>, pose_and_jacobian_kernel<8>};

const KernelTable<JacobianKernel> kQuickJacobianKernels = {
    quick_jacobian_kernel<kAnyCount>, quick_jacobian_kernel<1>, quick_jacobian_kernel<2>,
    quick_jacobian_kernel<3>,         quick_jacobian_kernel<4>, quick_jacobian_kernel<5>,
    quick_jacobian_kernel<6>,         quick_jacobian_kernel<7>, quick_jacobian_kernel<8>};

}  // namespace armlet
