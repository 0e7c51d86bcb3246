#include "chain/walk_out.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

template <int N>
void frames_kernel(const WalkPlan& plan, const double* q, double* frames, double* T_world_tool) {
  WalkFrame frame;
  if (plan.standard) {
    frame = walk_out<N>(
        plan, q, [](std::size_t, const WalkFrame&) {},
        [&](std::size_t i, const WalkFrame& link) {
          link.store(frames + 16 * i, plan.flip[i + 1]);
        });
    const std::size_t n = static_cast<std::size_t>(joint_count<N>(plan));
    WalkFrame flange = frame;
    flange.step_x(plan, n);
    flange.store(frames + 16 * (n - 1), plan.flip[n - 1]);
  } else {
    frame = walk_out<N>(
        plan, q,
        [&](std::size_t i, const WalkFrame& link) { link.store(frames + 16 * i, plan.flip[i]); },
        [](std::size_t, const WalkFrame&) {});
  }
  frame.step_tool(plan);
  frame.store(T_world_tool, 1.0);
}

}  // namespace

constinit const KernelTable<FramesKernel> kFramesKernels =
    kernel_table<FramesKernel>([]<int N>() { return &frames_kernel<N>; });

}  // namespace armlet
