#include "gravity.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

// Whether all axes are parallel to gravity, as in an upright SCARA: then a prismatic joint carries
// its mass and that beyond it, and a revolute joint carries nothing, for all joint values.
bool hang_upright(const DynamicsInput& in) {
  return in.plan.flat == in.plan.n && in.gravity[0] == 0.0 && in.gravity[1] == 0.0;
}

void upright_gravity(const DynamicsInput& in, double* tau) {
  const int n = static_cast<int>(in.plan.n);
  double doubt = 0.0;  // NaN afterwards if a joint value is not finite
  for (int i = 0; i < n; ++i) {
    const PlanLink& link = in.plan.links[i];
    doubt += in.q[i] - in.q[i];
    tau[i] = link.slides ? link.sign * (link.gravity.mass * in.gravity[2]) : 0.0;
  }
  tau[0] += doubt;
}

template <int N, bool kSlides>
void gravity_kernel(const DynamicsInput& in, double* tau) {
  if constexpr (kSlides) {
    if (hang_upright(in)) return upright_gravity(in, tau);
  }
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
