#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "armlet/chain/walk_plan.hpp"

// Kernels are compiled once for each number of joints up to kLargestKernel, so that their loops
// unroll and all values stay in registers, and once for any number. WebAssembly, whose code size
// matters, has only the latter, and dynamics of the usual arms; the bits are the same.
namespace armlet {

inline constexpr int kAnyCount = 0;
inline constexpr int kLargestKernel = 8;

// usual  the most frequent number for the kernel; 0: several.
constexpr bool has_own_kernel([[maybe_unused]] int n, [[maybe_unused]] int usual) {
#ifdef __wasm__
  return usual != kAnyCount && n == usual;
#else
  return true;
#endif
}

// The number of joints of a kernel that was compiled for N.
template <int N>
inline int joint_count(int n) {
  return N == kAnyCount ? n : N;
}
template <int N>
inline int joint_count(const WalkPlan& plan) {
  return joint_count<N>(plan.n);
}

// The largest number of joints for a kernel that was compiled for N.
template <int N>
inline constexpr std::size_t kJointCapacity = N == kAnyCount ? kMaxJoints : N;

// The instances of a kernel, a function type: [n] is for n joints, [kAnyCount] for any number.
template <class Kernel>
using KernelTable = std::array<Kernel*, kLargestKernel + 1>;

// The table of a function template. `instance` is a template itself, with the number of joints as
// its parameter: kernel_table<Kernel>([]<int N>() { return &kernel<N>; }).
template <class Kernel, int kUsual = kAnyCount, class Instance>
consteval KernelTable<Kernel> kernel_table(Instance instance) {
  return [instance]<int... N>(std::integer_sequence<int, N...>) {
    return KernelTable<Kernel>{
        instance.template operator() < has_own_kernel(N, kUsual) ? N : kAnyCount > ()...};
  }
  (std::make_integer_sequence<int, kLargestKernel + 1>());
}

template <class Kernel>
inline Kernel* kernel_for(const KernelTable<Kernel>& table, int n) {
  return table[n <= kLargestKernel ? static_cast<std::size_t>(n) : kAnyCount];
}

}  // namespace armlet
