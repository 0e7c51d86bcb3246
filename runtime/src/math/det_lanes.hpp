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

// What sincos_lanes() needs besides: added to a number of right angles it leaves it, not negative,
// in the lowest bits.
struct LaneNumbers : SinCosNumbers {
  static constexpr double shift = kRoundingMagic + LaneCheck<Lanes>::kFarthestCount;
};

// The same in every lane, in memory: where the instruction set takes operands from there, no
// number has to be brought into a register first.
template <class V>
struct LaneTable {
  using N = LaneNumbers;
  V two_over_pi = V{} + N::two_over_pi, shift = V{} + N::shift, half = V{} + N::half,
    one = V{} + N::one, part1 = V{} + N::part1, part2 = V{} + N::part2, rest2 = V{} + N::rest2;
  V S1 = V{} + N::S1, S2 = V{} + N::S2, S3 = V{} + N::S3, S4 = V{} + N::S4, S5 = V{} + N::S5,
    S6 = V{} + N::S6;
  V C1 = V{} + N::C1, C2 = V{} + N::C2, C3 = V{} + N::C3, C4 = V{} + N::C4, C5 = V{} + N::C5,
    C6 = V{} + N::C6;
};

// Two vectors side by side, to have something to do while one waits.
template <class V>
struct TwoLanes {
  V a, b;
  [[gnu::always_inline]] friend TwoLanes operator+(TwoLanes x, TwoLanes y) {
    return {x.a + y.a, x.b + y.b};
  }
  [[gnu::always_inline]] friend TwoLanes operator+(V x, TwoLanes y) { return {x + y.a, x + y.b}; }
  [[gnu::always_inline]] friend TwoLanes operator+(TwoLanes x, V y) { return {x.a + y, x.b + y}; }
  [[gnu::always_inline]] friend TwoLanes operator-(TwoLanes x, TwoLanes y) {
    return {x.a - y.a, x.b - y.b};
  }
  [[gnu::always_inline]] friend TwoLanes operator-(V x, TwoLanes y) { return {x - y.a, x - y.b}; }
  [[gnu::always_inline]] friend TwoLanes operator-(TwoLanes x, V y) { return {x.a - y, x.b - y}; }
  [[gnu::always_inline]] friend TwoLanes operator*(TwoLanes x, TwoLanes y) {
    return {x.a * y.a, x.b * y.b};
  }
  [[gnu::always_inline]] friend TwoLanes operator*(V x, TwoLanes y) { return {x * y.a, x * y.b}; }
  [[gnu::always_inline]] friend TwoLanes operator*(TwoLanes x, V y) { return {x.a * y, x.b * y}; }
};

// Sine and cosine of the rest of an angle, put where its right angles (the lowest bits of
// `shifted`) want them: the lowest bit swaps them; the next one and the sum of both are their
// signs.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> in_quadrant(V rest_sine, V rest_cosine, V shifted) {
  using Bits = LaneBits<V>;
  constexpr long kSignBit = static_cast<long>(1UL << 63);
  constexpr long kLowerBit = 1L << 62;
  const Bits sine = Bits(rest_sine);
  const Bits cosine = Bits(rest_cosine);
  const Bits quadrant = Bits(shifted);
  const Bits upper = quadrant << 62;
  const Bits sign = Bits{} + kSignBit;
  Bits swapped_sine, swapped_cosine;
  if constexpr (sizeof(V) > sizeof(Lanes)) {  // from AVX2 on, lanes are chosen in one instruction
    const Bits lower = quadrant << 63;
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
// check  hears whether they are settled.
template <class V, class Numbers = LaneNumbers>
[[gnu::always_inline]] inline LaneSinCos<V> sincos_lanes(V angle, LaneCheck<V>& check,
                                                         const Numbers& c = {}) {
  const V shifted = angle * c.two_over_pi + c.shift;
  const auto [hi, lo] = subtract_right_angles(angle, V(shifted - c.shift), c);
  check.add(hi * hi, LaneBits<V>(shifted) ^ __builtin_bit_cast(long, kRoundingMagic));
  return in_quadrant(sin_kernel(hi, lo, c), cos_kernel(hi, lo, c), shifted);
}

template <class V>
struct TwoSinCos {
  LaneSinCos<V> a, b;
};
template <class V>
[[gnu::always_inline]] inline TwoSinCos<V> sincos_lanes(TwoLanes<V> angle, LaneCheck<V>& check,
                                                        const LaneTable<V>& c) {
  const TwoLanes<V> shifted = angle * c.two_over_pi + c.shift;
  const auto [hi, lo] = subtract_right_angles(angle, shifted - c.shift, c);
  const auto magic = __builtin_bit_cast(long, kRoundingMagic);
  check.add(hi.a * hi.a, LaneBits<V>(shifted.a) ^ magic);
  check.add(hi.b * hi.b, LaneBits<V>(shifted.b) ^ magic);
  const TwoLanes<V> sine = sin_kernel(hi, lo, c);
  const TwoLanes<V> cosine = cos_kernel(hi, lo, c);
  return {in_quadrant(sine.a, cosine.a, shifted.a), in_quadrant(sine.b, cosine.b, shifted.b)};
}

}  // namespace armlet::det
