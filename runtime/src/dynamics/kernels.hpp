#pragma once

#include "chain/quick_sines.hpp"
#include "plan_dynamics.hpp"

namespace armlet {

// The inputs of a kernel. Pointers that it does not need may be null.
//
// q, qd, qdd, tau  n numbers each.
struct DynamicsInput {
  const WalkPlan& walk;
  const DynamicsPlan& plan;
  const double* q;
  const double* qd = nullptr;
  const double* qdd = nullptr;
  const double* gravity;  // three numbers, as DynamicsPlan::base_acceleration
};

// The kernels of dynamics for one configuration: one instance per number of joints, for arms with
// only revolute joints and for others. All leave friction out.
//
// forces   writes n joint forces, with the inertia of motors.
// M        writes n x n numbers.
// forward  reads n forces at `out` and replaces them by the accelerations. Returns n, or the first
//          joint, counted inward from the last, whose pivot is not above zero.
// throws   ArgumentError if a joint value is not finite.
using ForceKernel = void(const DynamicsInput& in, double* out);
using ForwardKernel = int(const DynamicsInput& in, double* out);

// The most frequent arms: SCARA, and six revolute joints.
constexpr int usual_count(bool slides) { return slides ? 4 : 6; }

// [0] for arms with revolute joints alone whose first two axes are not parallel, [1] for all.
extern const KernelTable<ForceKernel> kInverseKernels[2], kBiasKernels[2], kGravityKernels[2],
    kMassKernels[2];
extern const KernelTable<ForwardKernel> kForwardKernels[2];

template <class Kernel>
inline Kernel* kernel_for(const KernelTable<Kernel> (&tables)[2], const DynamicsPlan& plan) {
  return kernel_for(tables[plan.is_mixed()], static_cast<int>(plan.n));
}

// The sines and cosines of one configuration, with the bits that they have in a batch.
template <int N>
class SingleSines {
 public:
  [[gnu::always_inline]] explicit SingleSines(const DynamicsInput& in) : pairs_(in.walk, in.q) {}
  [[gnu::always_inline]] double sine(int i) const { return pairs_.sine(i)[0]; }
  [[gnu::always_inline]] double cosine(int i) const { return pairs_.cosine(i)[0]; }

 private:
  QuickJointSines<N, false> pairs_;
};

// The motion of one configuration with the signs of the plan.
struct SignedMotion {
  const DynamicsInput& in;

  [[gnu::always_inline]] double of(const double* values, int i) const {
    return in.plan.links[i].sign * values[i];
  }
  [[gnu::always_inline]] double q(int i) const { return of(in.q, i); }
  [[gnu::always_inline]] double qd(int i) const { return of(in.qd, i); }
  [[gnu::always_inline]] double qdd(int i) const { return of(in.qdd, i); }
};

}  // namespace armlet
