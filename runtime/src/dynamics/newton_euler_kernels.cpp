#include "kernels.hpp"
#include "newton_euler.hpp"

namespace armlet {
namespace {

template <int N, bool kSlides, bool kAccel>
void newton_euler_kernel(const DynamicsInput& in, double* tau) {
  const SingleSines<N> sines(in);
  const SignedMotion motion = {in};
  newton_euler<double, N, kSlides, kAccel>(
      in.plan, sines, motion, in.gravity, [&](int i, double force) __attribute__((always_inline)) {
        const PlanLink& link = in.plan.links[i];
        const double rigid = link.sign * force;
        if constexpr (kAccel) {
          tau[i] = rigid + link.motor_inertia * in.qdd[i];
        } else {
          tau[i] = rigid;
        }
      });
}

template <bool kSlides, bool kAccel>
constexpr KernelTable<ForceKernel> kTable = kernel_table<ForceKernel, usual_count(kSlides)>(
    []<int N>() { return &newton_euler_kernel<N, kSlides, kAccel>; });

}  // namespace

constinit const KernelTable<ForceKernel> kInverseKernels[2] = {kTable<false, true>,
                                                               kTable<true, true>};
constinit const KernelTable<ForceKernel> kBiasKernels[2] = {kTable<false, false>,
                                                            kTable<true, false>};

}  // namespace armlet
