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

// Sine and cosine per lane, and all bits set where they are settled. Elsewhere the angle is huge,
// not finite, or too close to a multiple of pi/2 for this reduction: ask sincos(double).
template <class V>
struct LaneSinCos {
  V sin, cos;
  LaneBits<V> settled;
};

inline constexpr long kSignBit = static_cast<long>(1UL << 63);
inline constexpr long kLowerBit = 1L << 62;

template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> sincos_lanes(V angle) {
  using Bits = LaneBits<V>;
  const V shifted = angle * kTwoOverPi + kRoundingMagic;
  const V fn = shifted - kRoundingMagic;
  const auto [hi, lo] = subtract_right_angles(angle, fn);
  const V allowed = fn * kNearestMultiple;
  const V allowed2 = allowed * allowed;
  const Bits settled = Bits(allowed2 <= hi * hi) & Bits(allowed2 < kFarthestMultiple);
  const Bits sine = Bits(sin_kernel(hi, lo));
  const Bits cosine = Bits(cos_kernel(hi, lo));
  // The shift by the magic number leaves the quadrant in the lowest bits: the lower one swaps sine
  // and cosine, the upper one and the sum of both are their signs.
  const Bits quadrant = Bits(shifted);
  const Bits upper = quadrant << 62;
  const Bits sign = Bits{} + kSignBit;
  Bits swapped_sine, swapped_cosine;
  if constexpr (sizeof(V) > sizeof(Lanes)) {
    const auto swap = (quadrant << 63) < 0;  // from AVX2 on, lanes are chosen in one instruction
    swapped_sine = swap ? cosine : sine;
    swapped_cosine = swap ? sine : cosine;
  } else {
    const Bits difference = (sine ^ cosine) & -(quadrant & 1);
    swapped_sine = sine ^ difference;
    swapped_cosine = cosine ^ difference;
  }
  return {V(swapped_sine ^ (upper & sign)), V(swapped_cosine ^ ((upper + kLowerBit) & sign)),
          settled};
}

}  // namespace armlet::det
