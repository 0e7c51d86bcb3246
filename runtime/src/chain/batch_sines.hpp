#pragma once

#include "batch_arm.hpp"
#include "lane_parts.hpp"
#include "math/det_quick_lanes.hpp"

// Sines and cosines of many configurations, one per lane. Like all kernels of batches it is
// compiled once per instruction set, in sources that include nothing else, with the same rounding
// of each operation: the bits are the same on each.
namespace armlet {

template <class V>
inline constexpr std::size_t kLanesOf = sizeof(V) / sizeof(double);

// Number of blocks whose sines are computed together.
inline constexpr std::size_t kGroupBlocks = 4;

// Constants of all blocks, in every lane.
template <class V>
struct BatchLanes {
  V theta[kBatchJoints], q_to_theta[kBatchJoints], d[kBatchJoints], a[kBatchJoints];
  det::QuickTable<V> numbers;

  [[gnu::always_inline]] explicit BatchLanes(const BatchArm& arm) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      theta[i] = all_lanes<V>(arm.theta[i]);
      q_to_theta[i] = all_lanes<V>(arm.q_to_theta[i]);
      d[i] = all_lanes<V>(arm.d[i]);
      a[i] = all_lanes<V>(arm.a[i]);
    }
  }

  // Hides from the compiler that they are constants, which it would load again each time.
  [[gnu::always_inline]] const det::QuickTable<V>& hidden_numbers() const {
    const det::QuickTable<V>* hidden = &numbers;
    asm("" : "+r"(hidden));
    return *hidden;
  }
};

// Blocks of one configuration per lane, the first from configuration `begin` on.
template <class V>
struct BatchGroup {
  const BatchArm& arm;
  const BatchLanes<V>& lanes;
  const double* q;
  std::size_t count, begin;

  // The configuration with which block b begins. The last block overlaps the one before, and later
  // blocks repeat it.
  [[gnu::always_inline]] std::size_t start(std::size_t b) const {
    const std::size_t k = begin + b * kLanesOf<V>;
    return k + kLanesOf<V> <= count ? k : count - kLanesOf<V>;
  }

  [[gnu::always_inline]] det::FourLanes<V> angles(std::size_t i) const {
    const double* values = q + i * count;
    const det::FourLanes<V> x = {load_lanes<V>(values + start(0)), load_lanes<V>(values + start(1)),
                                 load_lanes<V>(values + start(2)),
                                 load_lanes<V>(values + start(3))};
    return arm.plain(i) ? x : x * lanes.q_to_theta[i] + lanes.theta[i];
  }
};

template <class V>
struct BatchSines {
  static constexpr std::size_t kLanes = kLanesOf<V>;
  static constexpr std::size_t kStride = kGroupBlocks * kLanes;
  alignas(V) double sines[kBatchJoints * kStride];
  alignas(V) double cosines[kBatchJoints * kStride];

  [[gnu::always_inline]] explicit BatchSines(const BatchGroup<V>& group) {
    const det::QuickTable<V>& numbers = group.lanes.hidden_numbers();
    det::QuickCheck<V> check;
    for (std::size_t i = 0; i < group.arm.n; ++i) {
      const auto four = det::quick_sincos(group.angles(i), check, numbers);
      put(i, 0, four.a);
      put(i, 1, four.b);
      put(i, 2, four.c);
      put(i, 3, four.d);
    }
    if (check.any_too_large()) take_carefully(group);
  }

  [[gnu::always_inline]] V sine(std::size_t i, std::size_t b) const {
    return load_lanes<V>(sines + place(i, b));
  }
  [[gnu::always_inline]] V cosine(std::size_t i, std::size_t b) const {
    return load_lanes<V>(cosines + place(i, b));
  }

 private:
  static constexpr std::size_t place(std::size_t i, std::size_t b) {
    return i * kStride + b * kLanes;
  }

  [[gnu::always_inline]] void put(std::size_t i, std::size_t b, const det::LaneSinCos<V>& angle) {
    store_lanes(sines + place(i, b), angle.sin);
    store_lanes(cosines + place(i, b), angle.cos);
  }

  [[gnu::always_inline]] void take_carefully(const BatchGroup<V>& group) {
    for (std::size_t b = 0; b < kGroupBlocks; ++b) {
      careful_batch_sines(
          group.arm, group.q, group.count,
          {group.start(b), kLanes, kStride, sines + place(0, b), cosines + place(0, b)});
    }
  }
};

}  // namespace armlet
