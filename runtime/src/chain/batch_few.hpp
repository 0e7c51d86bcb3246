#pragma once

#include "batch_sines.hpp"

// Sines and cosines of a few configurations, fewer than a group of blocks. There is no preparation
// that would pay off only for many, and at most three vectors are computed twice.
namespace armlet {

// Blocks of one configuration per lane; the last one overlaps the one before.
template <class V>
struct FewBlocks {
  const BatchArm& arm;
  const double* q;
  std::size_t count;

  [[gnu::always_inline]] std::size_t size() const {
    return (count + kLanesOf<V> - 1) / kLanesOf<V>;
  }
  [[gnu::always_inline]] std::size_t start(std::size_t b) const {
    const std::size_t k = b * kLanesOf<V>;
    return k + kLanesOf<V> <= count ? k : count - kLanesOf<V>;
  }
  [[gnu::always_inline]] V values(std::size_t i, std::size_t b) const {
    return load_lanes<V>(q + i * count + start(b));
  }
};

// For a plain joint a group neither multiplies nor adds: multiplying by 1 and adding -0 gives the
// same bits.
template <class V>
[[gnu::always_inline]] inline V angle_of(const BatchArm& arm, std::size_t i, V value) {
  return value * all_lanes<V>(arm.q_to_theta[i]) + all_lanes<V>(arm.theta[i]);
}

// All vectors in sequence, the first joint's blocks, then the second's and so on, four at a time.
template <class V>
class FewSines {
 public:
  [[gnu::always_inline]] explicit FewSines(const FewBlocks<V>& few) : blocks_(few.size()) {
    const det::QuickTable<V> numbers;
    det::QuickCheck<V> check;
    const std::size_t all = few.arm.n * blocks_;
    std::size_t i = 0, b = 0, taken = 0;
    // After the last vector it repeats it.
    const auto next = [&]() __attribute__((always_inline)) {
      const V angle = angle_of<V>(few.arm, i, few.values(i, b));
      if (++taken < all && ++b == blocks_) {
        b = 0;
        ++i;
      }
      return angle;
    };
    for (std::size_t k = 0; k < all; k += 4) {
      const V first = next(), second = next(), third = next(), fourth = next();
      const auto four =
          det::quick_sincos(det::FourLanes<V>{first, second, third, fourth}, check, numbers);
      put(k, four.a);
      put(k + 1, four.b);
      put(k + 2, four.c);
      put(k + 3, four.d);
    }
    if (!check.any_too_large()) return;
    for (std::size_t block = 0; block < blocks_; ++block) {
      careful_batch_sines(few.arm, few.q, few.count,
                          {few.start(block), kLanes, blocks_ * kLanes, sines_ + block * kLanes,
                           cosines_ + block * kLanes});
    }
  }

  [[gnu::always_inline]] V sine(std::size_t i, std::size_t b) const {
    return load_lanes<V>(sines_ + (i * blocks_ + b) * kLanes);
  }
  [[gnu::always_inline]] V cosine(std::size_t i, std::size_t b) const {
    return load_lanes<V>(cosines_ + (i * blocks_ + b) * kLanes);
  }

 private:
  static constexpr std::size_t kLanes = kLanesOf<V>;
  static constexpr std::size_t kMost = (kBatchJoints * (kGroupBlocks - 1) + 3) / 4 * 4 * kLanes;

  [[gnu::always_inline]] void put(std::size_t k, const det::LaneSinCos<V>& angle) {
    store_lanes(sines_ + k * kLanes, angle.sin);
    store_lanes(cosines_ + k * kLanes, angle.cos);
  }

  std::size_t blocks_;
  alignas(V) double sines_[kMost];
  alignas(V) double cosines_[kMost];
};

// One of these blocks.
template <class V>
struct FewBlock {
  using Vector = V;
  const FewBlocks<V>& blocks;
  const FewSines<V>& sines;
  std::size_t b;

  [[gnu::always_inline]] const BatchArm& arm() const { return blocks.arm; }
  [[gnu::always_inline]] std::size_t count() const { return blocks.count; }
  [[gnu::always_inline]] V sine(std::size_t i) const { return sines.sine(i, b); }
  [[gnu::always_inline]] V cosine(std::size_t i) const { return sines.cosine(i, b); }
  [[gnu::always_inline]] V q_to_theta(std::size_t i) const {
    return all_lanes<V>(blocks.arm.q_to_theta[i]);
  }
  [[gnu::always_inline]] V a(std::size_t i) const { return all_lanes<V>(blocks.arm.a[i]); }
  [[gnu::always_inline]] V d(std::size_t i) const { return all_lanes<V>(blocks.arm.d[i]); }
  [[gnu::always_inline]] V q(std::size_t i) const { return blocks.values(i, b); }
};

}  // namespace armlet
