#include "composite.hpp"
#include "kernels.hpp"
#include "newton_euler.hpp"

namespace armlet {
namespace {

// Solves M x = b for a symmetric matrix by M = L' D L, from the last joint inward, in place: the
// entries that the composite bodies give first are eliminated first.
//
// M        the lower triangle is read and overwritten; element (row, column) at [column * stride +
//          row].
// returns  n, or the first row whose pivot is not above zero.
template <int N>
[[gnu::always_inline]] inline int solve_symmetric(double* M, int n, int stride, double* b) {
  double inverse[kJointCapacity<N>];
#pragma GCC unroll 8
  for (int k = n - 1; k >= 0; --k) {
    const double pivot = M[k * stride + k];
    if (!(pivot > 0.0)) [[unlikely]]
      return k;
    inverse[k] = 1.0 / pivot;
    // Columns j < k of row k become those of L.
#pragma GCC unroll 8
    for (int j = k - 1; j >= 0; --j) {
      const double l = M[j * stride + k] * inverse[k];
#pragma GCC unroll 8
      for (int i = j; i >= 0; --i) M[i * stride + j] -= l * M[i * stride + k];
      b[j] -= l * b[k];
      M[j * stride + k] = l;
    }
  }
#pragma GCC unroll 8
  for (int k = 0; k < n; ++k) {
    double sum = b[k] * inverse[k];
#pragma GCC unroll 8
    for (int j = 0; j < k; ++j) sum -= M[j * stride + k] * b[j];
    b[k] = sum;
  }
  return n;
}

template <int N, bool kSlides>
int forward_kernel(const DynamicsInput& in, double* out) {
  constexpr int kCapacity = static_cast<int>(kJointCapacity<N>);
  const int n = joint_count<N>(in.walk);
  const SingleSines<N> sines(in);
  const SignedMotion motion = {in};
  double M[kCapacity * kCapacity], b[kCapacity];
  newton_euler<double, N, kSlides, false>(
      in.plan, sines, motion, in.gravity, [&](int i, double force) __attribute__((always_inline)) {
        b[i] = in.plan.links[i].sign * out[i] - force;
      });
  composite_bodies<N, kSlides>(
      in.plan, sines,
      motion, [&](int row, int column, double value) __attribute__((always_inline)) {
        M[column * kCapacity + row] = value;
      });
  const int solved = solve_symmetric<N>(M, n, kCapacity, b);
#pragma GCC unroll 8
  for (int i = 0; i < n; ++i) out[i] = in.plan.links[i].sign * b[i];
  return solved;
}

template <bool kSlides>
constexpr KernelTable<ForwardKernel> kForwardTable =
    kernel_table<ForwardKernel, usual_count(kSlides)>([]<int N>() {
      return &forward_kernel<N, kSlides>;
    });

}  // namespace

constinit const KernelTable<ForwardKernel> kForwardKernels[2] = {kForwardTable<false>,
                                                                 kForwardTable<true>};

}  // namespace armlet
