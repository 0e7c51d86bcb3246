#pragma once

#include <cstdint>

#include "det_polynomials.hpp"

// Sines and cosines of several numbers in parallel. Every vector operation is the same operation on
// each lane, so the results have the bits of single numbers, whatever the width. All functions are
// always inlined: sources that are compiled for a larger instruction set must not emit functions
// that other code could be linked to.
namespace armlet::det {

// Two numbers, the width that every x86-64 machine has.
using Lanes = double __attribute__((vector_size(16)));

// Integers of the same width, the results of comparisons of lanes.
template <class V>
using LaneBits = decltype(V{} < V{});

// Unsigned integers of the same width, whose arithmetic does not overflow.
template <class V>
struct PlainBits {
  typedef std::uint64_t type __attribute__((vector_size(sizeof(V))));
};

template <class V>
struct LaneSinCos {
  V sin, cos;
};

// Exactly rounded, as on every set.
template <class V>
[[gnu::always_inline]] inline V root(V square) {
#if defined(__SSE2__) && !defined(__clang__)
  if constexpr (sizeof(V) == 16) return __builtin_ia32_sqrtpd(square);
  if constexpr (sizeof(V) == 32) return __builtin_ia32_sqrtpd256(square);
  if constexpr (sizeof(V) == 64) return __builtin_ia32_sqrtpd512_mask(square, square, -1, 4);
#else
  for (unsigned lane = 0; lane < sizeof(V) / sizeof(double); ++lane)
    square[lane] = __builtin_sqrt(square[lane]);
  return square;
#endif
}

// Collects over several vectors of angles whether all results are final: within 2^7 right angles,
// and not so close to a multiple of a right angle that the parts of pi/2 are not exact enough. Zero
// is not such a multiple. Otherwise sincos(double) has to be called.
template <class V>
struct LaneCheck {
  V nearest = V{} + 1.0;      // smallest square of a difference, minus one step; NaN for zero
  LaneBits<V> farthest = {};  // bits that are set only for too many right angles

  [[gnu::always_inline]] void add(V square, LaneBits<V> count) {
    const V below = V(LaneBits<V>(square) - 1);
    nearest = below < nearest ? below : nearest;
    farthest |= count;
  }

  [[gnu::always_inline]] bool all_settled() const {
    // Integers are compared one by one, since the smallest instruction set has no vector comparison
    // for them.
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
  static constexpr std::int64_t kFarthestCount = 1 << 7;
};

// Selects sine and cosine of the remainder by the number of right angles (the lowest bits of
// `shifted`): the lowest bit exchanges them; the next one and the sum of both are their signs.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> in_quadrant(V rest_sine, V rest_cosine, V shifted) {
  using Bits = typename PlainBits<V>::type;
  constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63U;
  constexpr std::uint64_t kLowerBit = std::uint64_t{1} << 62U;
  const Bits sine = Bits(rest_sine);
  const Bits cosine = Bits(rest_cosine);
  const Bits quadrant = Bits(shifted);
  const Bits upper = quadrant << 62;
  const Bits sign = Bits{} + kSignBit;
  Bits swapped_sine, swapped_cosine;
  // from AVX2 on, there is an instruction for the selection
  if constexpr (sizeof(V) > sizeof(Lanes)) {
    const auto lower = LaneBits<V>(quadrant << 63);
    swapped_sine = Bits(lower < 0 ? rest_cosine : rest_sine);
    swapped_cosine = Bits(lower < 0 ? rest_sine : rest_cosine);
  } else {
    const Bits difference = (sine ^ cosine) & -(quadrant & 1);
    swapped_sine = sine ^ difference;
    swapped_cosine = cosine ^ difference;
  }
  return {V(swapped_sine ^ (upper & sign)), V(swapped_cosine ^ ((upper + kLowerBit) & sign))};
}

// Sines and cosines of the lanes.
//
// check  receives whether all of them are final.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> sincos_lanes(V angle, LaneCheck<V>& check) {
  // Added to a number of right angles it leaves it, not negative, in the lowest bits.
  constexpr double kShift = kRoundingMagic + LaneCheck<Lanes>::kFarthestCount;
  const V shifted = angle * kTwoOverPi + kShift;
  const auto [hi, lo] = subtract_right_angles(angle, V(shifted - kShift));
  check.add(hi * hi, LaneBits<V>(shifted) ^ __builtin_bit_cast(std::int64_t, kRoundingMagic));
  return in_quadrant(sin_kernel(hi, lo), cos_kernel(hi, lo), shifted);
}

}  // namespace armlet::det
