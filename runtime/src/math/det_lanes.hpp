#pragma once

#include "det_polynomials.hpp"

// Sines and cosines of several numbers side by side. Every operation on a vector is the same
// operation on each lane, so results have the bits of one by one, whatever the width. All is
// inlined by force: sources that are compiled for a larger instruction set must not leave functions
// behind that others could be linked to.
namespace armlet::det {

// Two numbers, the width that every x86-64 machine has.
using Lanes = double __attribute__((vector_size(16)));

// Whole numbers of the same width; what a comparison of lanes gives.
template <class V>
using LaneBits = decltype(V{} < V{});

template <class V>
struct LaneSinCos {
  V sin, cos;
};

// Remembers over several vectors of angles whether all are settled: within 2^7 right angles, and
// not so close to a multiple of a right angle that its parts are not enough. Zero is no such
// multiple. Otherwise sincos(double) has to be asked.
template <class V>
struct LaneCheck {
  V nearest = V{} + 1.0;      // the smallest square of a difference, one step down; NaN for zero
  LaneBits<V> farthest = {};  // bits that no number of right angles should have

  [[gnu::always_inline]] void add(V square, LaneBits<V> count) {
    const V below = V(LaneBits<V>(square) - 1);
    nearest = below < nearest ? below : nearest;
    farthest |= count;
  }

  [[gnu::always_inline]] bool all_settled() const {
    // Whole numbers are compared one by one, for which the smallest instruction set has nothing.
    const LaneBits<V> near = nearest >= kNearestSquare;
    auto far = farthest[0];
    auto all_near = near[0];
    for (unsigned lane = 1; lane < sizeof(V) / sizeof(double); ++lane) {
      far |= farthest[lane];
      all_near &= near[lane];
    }
#ifdef __SSE2__
    if constexpr (sizeof(V) == sizeof(Lanes)) all_near = __builtin_ia32_movmskpd(V(near)) == 3;
#endif
    return all_near != 0 && far < 2 * kFarthestCount && far >= 0;
  }

  static constexpr double kNearestSquare = 0x1p-108;
  static constexpr long kFarthestCount = 1 << 7;
};

// Sines and cosines of the lanes.
//
// check  hears whether they are settled.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> sincos_lanes(V angle, LaneCheck<V>& check) {
  using Bits = LaneBits<V>;
  constexpr double kShift = kRoundingMagic + LaneCheck<V>::kFarthestCount;
  constexpr long kSignBit = static_cast<long>(1UL << 63);
  constexpr long kLowerBit = 1L << 62;
  // Leaves the number of right angles, not negative, in the lowest bits.
  const V shifted = angle * kTwoOverPi + kShift;
  const auto [hi, lo] = subtract_right_angles(angle, shifted - kShift);
  check.add(hi * hi, Bits(shifted) ^ __builtin_bit_cast(long, kRoundingMagic));
  const Bits sine = Bits(sin_kernel(hi, lo));
  const Bits cosine = Bits(cos_kernel(hi, lo));
  // The lowest bit swaps sine and cosine; the next one and the sum of both are their signs.
  const Bits quadrant = Bits(shifted);
  const Bits upper = quadrant << 62;
  const Bits sign = Bits{} + kSignBit;
  Bits swapped_sine, swapped_cosine;
  if constexpr (sizeof(V) > sizeof(Lanes)) {  // from AVX2 on, lanes are chosen in one instruction
    const Bits lower = quadrant << 63;
    swapped_sine = Bits(lower < 0 ? V(cosine) : V(sine));
    swapped_cosine = Bits(lower < 0 ? V(sine) : V(cosine));
  } else {
    const Bits difference = (sine ^ cosine) & -(quadrant & 1);
    swapped_sine = sine ^ difference;
    swapped_cosine = cosine ^ difference;
  }
  return {V(swapped_sine ^ (upper & sign)), V(swapped_cosine ^ ((upper + kLowerBit) & sign))};
}

}  // namespace armlet::det
