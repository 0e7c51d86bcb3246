#include "gravity.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

template <int N, bool kSlides>
void gravity_kernel(const DynamicsInput& in, double* tau) {
  const SingleSines<N> sines(in);
  gravity_recursion<double, N, kSlides>(
      in.plan, sines, SignedMotion{in},
      in.gravity, [&](int i, double force) __attribute__((always_inline)) {
        tau[i] = in.plan.links[i].sign * force;
      });
}

template <bool kSlides>
constexpr KernelTable<ForceKernel> kGravityTable = kernel_table<ForceKernel, usual_count(kSlides)>(
    []<int N>() { return &gravity_kernel<N, kSlides>; });

}  // namespace

constinit const KernelTable<ForceKernel> kGravityKernels[2] = {kGravityTable<false>,
                                                               kGravityTable<true>};

}  // namespace armlet
