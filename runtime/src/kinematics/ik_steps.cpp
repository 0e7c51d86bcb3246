#include "ik_steps.hpp"

#include "turns.hpp"

namespace armlet {
namespace {

template <int N>
constexpr std::size_t kCapacity = N == kAnyCount ? kMaxJoints : N;

template <int N>
std::size_t count_of(int n) {
  return static_cast<std::size_t>(N == kAnyCount ? n : N);
}

// Six numbers.
struct Six {
  Lanes a, b, c;

  explicit Six(const double* p) : a(load_pair(p)), b(load_pair(p + 2)), c(load_pair(p + 4)) {}
  // The sums of even and odd products.
  friend Lanes operator*(const Six& x, const Six& y) { return x.a * y.a + x.b * y.b + x.c * y.c; }
};

// The sums of both lanes of p and of q.
inline Lanes sums(Lanes p, Lanes q) { return Lanes{p[0], q[0]} + Lanes{p[1], q[1]}; }

template <int N>
void normal_kernel(int joints, const double* J, const double* e, NormalEquations& normal) {
  const std::size_t n = count_of<N>(joints);
  const Six error(e);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) {
    const Six column(J + 6 * i);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < i; k += 2) {
      store_pair(normal.A[i] + k, sums(column * Six(J + 6 * k), column * Six(J + 6 * (k + 1))));
    }
    const Lanes last = sums(column * column, column * error);
    normal.A[i][i] = last[0];
    normal.b[i] = last[1];
  }
}

// L D L^T; M holds L D. A pivot that is nothing but rounding belongs to a joint that the others
// stand in for, of a redundant or singular arm: it stays where it is. Divided by, such a pivot
// would make the next ones grow without bound.
template <int N>
void step_kernel(int joints, const NormalEquations& normal, double damping, double* step) {
  const std::size_t n = count_of<N>(joints);
  double L[kCapacity<N>][kCapacity<N>], M[kCapacity<N>][kCapacity<N>];
  double inverse_pivot[kCapacity<N>], x[kCapacity<N>];
  double trace = 0.0;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) trace += normal.A[i][i];
  const double floor = 1e-14 * trace + 1e-300;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) {
    double pivot = normal.A[i][i] + damping;
    double value = normal.b[i];
#pragma GCC unroll 8
    for (std::size_t k = 0; k < i; ++k) {
      double sum = normal.A[i][k];
#pragma GCC unroll 8
      for (std::size_t j = 0; j < k; ++j) sum -= M[i][j] * L[k][j];
      M[i][k] = sum;
      L[i][k] = sum * inverse_pivot[k];
      pivot -= sum * L[i][k];
      value -= L[i][k] * x[k];
    }
    inverse_pivot[i] = pivot > floor ? 1.0 / pivot : 0.0;
    x[i] = value;
  }
#pragma GCC unroll 8
  for (std::size_t behind = 0; behind < n; ++behind) {
    const std::size_t i = n - 1 - behind;
    double value = x[i] * inverse_pivot[i];
#pragma GCC unroll 8
    for (std::size_t j = i + 1; j < n; ++j) value -= L[j][i] * x[j];
    x[i] = value;
  }
  // In pairs, because pairs are read next: two numbers written one by one would be waited for.
  if (n % 2 == 1) step[n - 1] = x[n - 1];
#pragma GCC unroll 8
  for (std::size_t i = 0; i + 1 < n; i += 2) store_pair(step + i, Lanes{x[i], x[i + 1]});
}

}  // namespace

const KernelTable<NormalKernel> kNormalKernels = {
    normal_kernel<kAnyCount>, normal_kernel<1>, normal_kernel<2>,
    normal_kernel<3>,         normal_kernel<4>, normal_kernel<5>,
    normal_kernel<6>,         normal_kernel<7>, normal_kernel<8>};

const KernelTable<StepKernel> kStepKernels = {
    step_kernel<kAnyCount>, step_kernel<1>, step_kernel<2>, step_kernel<3>, step_kernel<4>,
    step_kernel<5>,         step_kernel<6>, step_kernel<7>, step_kernel<8>};

}  // namespace armlet
