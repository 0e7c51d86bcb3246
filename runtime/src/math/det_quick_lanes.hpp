#pragma once

#include "det_lanes.hpp"

// Sines and cosines for batches, for throughput rather than latency: within two units in the last
// place, with about half the operations of sincos_lanes(). Every operation is rounded exactly, so
// the bits do not depend on the width either.
namespace armlet::det {

// Four independent vectors. A processor executes about a hundred operations ahead, which is one
// step for all four: it works on the others while it waits for the results of the step before.
template <class V>
struct FourLanes {
  V a, b, c, d;
  [[gnu::always_inline]] friend FourLanes operator+(FourLanes x, FourLanes y) {
    return {x.a + y.a, x.b + y.b, x.c + y.c, x.d + y.d};
  }
  [[gnu::always_inline]] friend FourLanes operator+(FourLanes x, V y) {
    return {x.a + y, x.b + y, x.c + y, x.d + y};
  }
  [[gnu::always_inline]] friend FourLanes operator-(FourLanes x, FourLanes y) {
    return {x.a - y.a, x.b - y.b, x.c - y.c, x.d - y.d};
  }
  [[gnu::always_inline]] friend FourLanes operator-(FourLanes x, V y) {
    return {x.a - y, x.b - y, x.c - y, x.d - y};
  }
  [[gnu::always_inline]] friend FourLanes operator-(V x, FourLanes y) {
    return {x - y.a, x - y.b, x - y.c, x - y.d};
  }
  [[gnu::always_inline]] friend FourLanes operator*(FourLanes x, FourLanes y) {
    return {x.a * y.a, x.b * y.b, x.c * y.c, x.d * y.d};
  }
  [[gnu::always_inline]] friend FourLanes operator*(FourLanes x, V y) {
    return {x.a * y, x.b * y, x.c * y, x.d * y};
  }
};

// Angles are counted in units of 2^7 right angles, so that one bit marks those that are too large.
struct QuickNumbers {
  static constexpr double kUnit = 0x1p7;
  static constexpr double per_angle = kTwoOverPi / kUnit;     // units per radian
  static constexpr double rounding = kRoundingMagic / kUnit;  // to whole right angles
  // pi/2 in 45 bits, whose whole multiples up to 2^8 are exact, and a rest; radians per unit.
  static constexpr double part1 = 0x1.921fb54442dp+0 * kUnit, part2 = 0x1.8469898cc517p-48 * kUnit;
};

// Whether the angle has to be computed by sincos(double): from 2^8 right angles on, and if it is
// not finite.
[[gnu::always_inline]] inline bool is_too_large(double angle) {
  return !(__builtin_fabs(angle * QuickNumbers::per_angle) < 2.0);
}

// Remembers over several vectors whether any of their angles is too large: numbers of at least 2,
// infinite ones and NaN are those whose uppermost bit of the exponent is set.
template <class V>
struct QuickCheck {
  LaneBits<V> bits = {};

  [[gnu::always_inline]] void add(const FourLanes<V>& units) {
    bits |= (LaneBits<V>(units.a) | LaneBits<V>(units.b)) |
            (LaneBits<V>(units.c) | LaneBits<V>(units.d));
  }

  [[gnu::always_inline]] bool any_too_large() const {
    auto all = bits[0];
    for (unsigned lane = 1; lane < sizeof(V) / sizeof(double); ++lane) all |= bits[lane];
    return (all >> 62 & 1) != 0;
  }
};

// The constants of quick_sincos(), in every lane, in memory: instruction sets with memory operands
// need not load them into registers.
template <class V>
struct QuickTable {
  using N = QuickNumbers;
  using P = SinCosNumbers;
  V per_angle = V{} + N::per_angle, rounding = V{} + N::rounding, part1 = V{} + N::part1,
    part2 = V{} + N::part2, one = V{} + 1.0;
  V S1 = V{} + P::S1, S2 = V{} + P::S2, S3 = V{} + P::S3, S4 = V{} + P::S4, S5 = V{} + P::S5,
    S6 = V{} + P::S6;
  V C1 = V{} + P::C1, C2 = V{} + P::C2, C3 = V{} + P::C3, C4 = V{} + P::C4, C5 = V{} + P::C5,
    C6 = V{} + P::C6;
};

template <class V>
struct FourSinCos {
  LaneSinCos<V> a, b, c, d;
};

// Sine and cosine of the remainder of an angle, at most an eighth of a revolution. The cosine is
// the square root of 1 minus the squared sine: no digit is lost, and the divider works in parallel
// with the multipliers. The polynomial of the sine is split into even and odd powers, which
// shortens the chain of operations.
template <class V, class Vectors>
[[gnu::always_inline]] inline void quick_rest(const Vectors& angle, const QuickTable<V>& c,
                                              Vectors& shifted, Vectors& sine, Vectors& square) {
  shifted = angle * c.per_angle + c.rounding;
  const Vectors whole = shifted - c.rounding;
  const Vectors r = (angle - whole * c.part1) - whole * c.part2;
  const Vectors z = r * r;
  const Vectors z2 = z * z;
  const Vectors odd = (z2 * c.S5 + c.S3) * z2 + c.S1;
  const Vectors even = (z2 * c.S6 + c.S4) * z2 + c.S2;
  sine = r + (r * z) * (odd + z * even);
  square = c.one - sine * sine;
}

// Sines and cosines of the lanes.
//
// check  receives whether any angle is too large; its results are then meaningless.
template <class V>
[[gnu::always_inline]] inline FourSinCos<V> quick_sincos(const FourLanes<V>& angle,
                                                         QuickCheck<V>& check,
                                                         const QuickTable<V>& c) {
  check.add(angle * c.per_angle);
  FourLanes<V> shifted, sine, square;
  quick_rest(angle, c, shifted, sine, square);
  return {in_quadrant(sine.a, root(square.a), shifted.a),
          in_quadrant(sine.b, root(square.b), shifted.b),
          in_quadrant(sine.c, root(square.c), shifted.c),
          in_quadrant(sine.d, root(square.d), shifted.d)};
}

// Sines and cosines of the lanes of one vector.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> quick_sincos(V angle, QuickCheck<V>& check,
                                                         const QuickTable<V>& c) {
  check.bits |= LaneBits<V>(angle * c.per_angle);
  V shifted, sine, square;
  quick_rest(angle, c, shifted, sine, square);
  return in_quadrant(sine, root(square), shifted);
}

// The version of low latency, as needed between iterations: the same remainder of the angle and
// both polynomials in pairs of terms, which shortens the chain of operations by a third. Within
// 2^-52 of the true values.
template <class V>
[[gnu::always_inline]] inline LaneSinCos<V> prompt_sincos(V angle, QuickCheck<V>& check,
                                                          const QuickTable<V>& c) {
  check.bits |= LaneBits<V>(angle * c.per_angle);
  const V shifted = angle * c.per_angle + c.rounding;
  const V whole = shifted - c.rounding;
  const V r = (angle - whole * c.part1) - whole * c.part2;
  const V z = r * r;
  const V z2 = z * z;
  const V sine = (c.S1 + c.S2 * z) + z2 * ((c.S3 + c.S4 * z) + z2 * (c.S5 + c.S6 * z));
  const V cosine = (c.C1 + c.C2 * z) + z2 * ((c.C3 + c.C4 * z) + z2 * (c.C5 + c.C6 * z));
  return in_quadrant(V(r + (r * z) * sine), V((c.one - 0.5 * z) + z2 * cosine), shifted);
}

}  // namespace armlet::det
