#pragma once

#include "batch_few.hpp"

// Kernels for many configurations, one per lane, in consecutive blocks.
namespace armlet {

// The configurations from number k on: block b of its group.
template <class V>
struct GroupBlock {
  using Vector = V;
  const BatchGroup<V>& group;
  const BatchSines<V>& sines;
  std::size_t b, k;

  [[gnu::always_inline]] const BatchArm& arm() const { return group.arm; }
  [[gnu::always_inline]] std::size_t count() const { return group.count; }
  [[gnu::always_inline]] V sine(std::size_t i) const { return sines.sine(i, b); }
  [[gnu::always_inline]] V cosine(std::size_t i) const { return sines.cosine(i, b); }
  [[gnu::always_inline]] V q_to_theta(std::size_t i) const { return group.lanes.q_to_theta[i]; }
  [[gnu::always_inline]] V a(std::size_t i) const { return group.lanes.a[i]; }
  [[gnu::always_inline]] V d(std::size_t i) const { return group.lanes.d[i]; }
  [[gnu::always_inline]] V q(std::size_t i) const {
    return load_lanes<V>(group.q + i * group.count + k);
  }
};

// For fewer configurations than a group.
template <class V, class Write>
[[gnu::always_inline]] inline void few_configurations(const BatchArm& arm, const double* q,
                                                      std::size_t count, const Write& write) {
  const FewBlocks<V> blocks = {arm, q, count};
  const FewSines<V> sines(blocks);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    write(FewBlock<V>{blocks, sines, b}, blocks.start(b));
  }
}

// For all configurations, a group of blocks at a time: write(block, k) processes the configurations
// of a block, of which k is the first.
template <class V, class Write>
[[gnu::always_inline]] inline void all_configurations(const BatchArm& arm, const double* q,
                                                      std::size_t count, const Write& write) {
  const BatchLanes<V> lanes(arm);
  for (std::size_t begin = 0; begin < count; begin += kGroupBlocks * kLanesOf<V>) {
    const BatchGroup<V> group = {arm, lanes, q, count, begin};
    const BatchSines<V> sines(group);
    for (std::size_t b = 0; b < kGroupBlocks && begin + b * kLanesOf<V> < count; ++b) {
      const std::size_t k = group.start(b);
      write(GroupBlock<V>{group, sines, b, k}, k);
    }
  }
}

template <class V>
[[gnu::always_inline]] inline bool are_few(std::size_t count) {
  return count <= (kGroupBlocks - 1) * kLanesOf<V>;
}

// A BatchKernel. What::write(block, out) writes the entries of the configurations of a block, entry
// e at out + e * block.count().
template <class V, class What>
[[gnu::noinline]] static void few_entries(const BatchArm& arm, const double* q, std::size_t count,
                                          double* out) {
  few_configurations<V>(
      arm, q, count, [&](const auto& block, std::size_t k) __attribute__((always_inline)) {
        What::write(block, out + k);
      });
}
template <class V, class What>
void batch_kernel(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  if (are_few<V>(count)) return few_entries<V, What>(arm, q, count, out);
  all_configurations<V>(
      arm, q, count, [&](const auto& block, std::size_t k) __attribute__((always_inline)) {
        What::write(block, out + k);
      });
}

}  // namespace armlet
