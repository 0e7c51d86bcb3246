#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "armlet/math/det_math.hpp"

// Building blocks of det_math: exact sums and products, argument reduction, polynomials.
// The polynomials and their coefficients are those of fdlibm (Sun Microsystems, 1993), which may be
// used freely provided that its notice is preserved:
//   Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunSoft, a Sun
//   Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is
//   freely granted, provided that this notice is preserved.
namespace armlet::det {

// A number as an unevaluated sum; lo is smaller than half a unit in the last place of hi.
struct Pair {
  double hi = 0.0;
  double lo = 0.0;
};

// a + b exactly (Knuth).
inline Pair two_sum(double a, double b) {
  const double s = a + b;
  const double b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

// The same, for |a| >= |b| (Dekker).
inline Pair fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

// a * b exactly without fused multiply-add (Dekker); |a|, |b| below 1e300.
inline Pair two_product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double a_big = kSplit * a;
  const double a_hi = a_big - (a_big - a);
  const double a_lo = a - a_hi;
  const double b_big = kSplit * b;
  const double b_hi = b_big - (b_big - b);
  const double b_lo = b - b_hi;
  const double p = a * b;
  return {p, ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

// The number with its lower 32 bits cleared, so that products of two of them are exact.
inline double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xffffffff00000000u);
}

// x = quadrant * pi/2 + r, |r| <= pi/4 (and a little); only quadrant mod 4 is kept.
struct Reduced {
  Pair r;
  std::int64_t quadrant = 0;
};

inline constexpr double kMediumAngle = 262144.0;    // 2^18: multiples of pi/2 stay exact below
Reduced reduce_large(double x);                     // any finite |x|
Reduced reduce_near_multiple(double x, double fn);  // fn pi/2 is very close to x

// Adding and subtracting it rounds to the nearest integer, ties to even, below 2^51: 1.5 * 2^52.
inline constexpr double kRoundingMagic = 6755399441055744.0;
inline double round_to_even(double x) { return (x + kRoundingMagic) - kRoundingMagic; }

// Cody and Waite: pi/2 in parts of 33 bits, so that fn times a part has no rounding error.
inline constexpr double kTwoOverPi = 6.36619772367581382433e-01;
inline constexpr double kHalfPiPart1 = 1.57079632673412561417e+00;
inline constexpr double kHalfPiRest1 = 6.07710050650619224932e-11;

inline Reduced reduce_angle(double x) {
  if (!(std::abs(x) < kMediumAngle)) return reduce_large(x);
  const double fn = round_to_even(x * kTwoOverPi);
  const double t = x - fn * kHalfPiPart1;
  const double w = fn * kHalfPiRest1;
  const double hi = t - w;
  if (std::abs(hi) < 0x1p-8 && fn != 0.0) return reduce_near_multiple(x, fn);
  return {{hi, (t - hi) - w}, static_cast<std::int64_t>(fn)};
}

// Two numbers side by side: every operation on them is the same operation on each, so results have
// the same bits as one by one.
using Lanes = double __attribute__((vector_size(16)));
using LaneBits = std::uint64_t __attribute__((vector_size(16)));

// sin(hi + lo) for |hi| <= pi/4 and a little; of one number or of two lanes.
template <class Number>
inline Number sin_kernel(Number hi, Number lo) {
  constexpr double S1 = -1.66666666666666324348e-01, S2 = 8.33333333332248946124e-03,
                   S3 = -1.98412698298579493134e-04, S4 = 2.75573137070700676789e-06,
                   S5 = -2.50507602534068634195e-08, S6 = 1.58969099521155010221e-10;
  const Number z = hi * hi;
  const Number v = z * hi;
  const Number p = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  return hi - ((z * (0.5 * lo - v * p) - lo) - v * S1);
}

// cos(hi + lo) for |hi| <= pi/4 and a little.
template <class Number>
inline Number cos_kernel(Number hi, Number lo) {
  constexpr double C1 = 4.16666666666666019037e-02, C2 = -1.38888888888741095749e-03,
                   C3 = 2.48015872894767294178e-05, C4 = -2.75573143513906633035e-07,
                   C5 = 2.08757232129817482790e-09, C6 = -1.13596475577881948265e-11;
  const Number z = hi * hi;
  const Number p = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
  const Number half = 0.5 * z;
  const Number w = 1.0 - half;
  return w + (((1.0 - w) - half) + (z * p - hi * lo));
}

// Sine and cosine of any angle; inline because the recursions of the arm spend their time here.
inline SinCos sincos_inline(double x) {
  const Reduced a = reduce_angle(x);
  const double s = sin_kernel(a.r.hi, a.r.lo);
  const double c = cos_kernel(a.r.hi, a.r.lo);
  const bool swap = (a.quadrant & 1) != 0;
  const double sine = swap ? c : s;
  const double cosine = swap ? s : c;
  return {(a.quadrant & 2) != 0 ? -sine : sine, ((a.quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

// Sines and cosines of two angles at once, with the same bits as one by one.
inline void sincos_lanes(const double* x, double* s, double* c) {
  const Lanes angle = {x[0], x[1]};
  const Lanes shifted = angle * kTwoOverPi + kRoundingMagic;
  const Lanes fn = shifted - kRoundingMagic;
  const Lanes t = angle - fn * kHalfPiPart1;
  const Lanes w = fn * kHalfPiRest1;
  const Lanes hi = t - w;
  for (int i = 0; i < 2; ++i) {
    if (std::abs(x[i]) < kMediumAngle && (std::abs(hi[i]) >= 0x1p-8 || fn[i] == 0.0)) continue;
    for (int k = 0; k < 2; ++k) {
      const SinCos sc = sincos_inline(x[k]);
      s[k] = sc.sin;
      c[k] = sc.cos;
    }
    return;
  }
  const Lanes lo = (t - hi) - w;
  const LaneBits sine = std::bit_cast<LaneBits>(sin_kernel(hi, lo));
  const LaneBits cosine = std::bit_cast<LaneBits>(cos_kernel(hi, lo));
  // The shift by the magic number leaves the quadrant in the lowest bits.
  const LaneBits quadrant = std::bit_cast<LaneBits>(shifted);
  const LaneBits odd = 0 - (quadrant & 1);
  const LaneBits s_bits = ((cosine & odd) | (sine & ~odd)) ^ ((quadrant & 2) << 62);
  const LaneBits c_bits = ((sine & odd) | (cosine & ~odd)) ^ (((quadrant + 1) & 2) << 62);
  const Lanes s_lanes = std::bit_cast<Lanes>(s_bits);
  const Lanes c_lanes = std::bit_cast<Lanes>(c_bits);
  for (int i = 0; i < 2; ++i) {
    s[i] = s_lanes[i];
    c[i] = c_lanes[i];
  }
}

}  // namespace armlet::det
