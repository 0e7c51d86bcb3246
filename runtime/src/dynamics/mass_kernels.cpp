#include "composite.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

template <int N, bool kSlides>
void mass_kernel(const DynamicsInput& in, double* M) {
  const SingleSines<N> sines(in);
  const int n = joint_count<N>(in.walk);
  composite_bodies<N, kSlides>(
      in.plan, sines,
      SignedMotion{in}, [&](int row, int column, double value) __attribute__((always_inline)) {
        const double entry = in.plan.links[row].sign * in.plan.links[column].sign * value;
        M[column * n + row] = entry;
        M[row * n + column] = entry;
      });
}

template <bool kSlides>
constexpr KernelTable<ForceKernel> kMassTable = kernel_table<ForceKernel, usual_count(kSlides)>(
    []<int N>() { return &mass_kernel<N, kSlides>; });

}  // namespace

constinit const KernelTable<ForceKernel> kMassKernels[2] = {kMassTable<false>, kMassTable<true>};

}  // namespace armlet
