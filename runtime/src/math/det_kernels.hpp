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

// Nearest integer, ties to even, without a library call; |x| < 2^51.
inline double round_to_even(double x) {
  constexpr double kMagic = 6755399441055744.0;  // 1.5 * 2^52
  return (x + kMagic) - kMagic;
}

// Cody and Waite: pi/2 in parts of 33 bits, so that fn times a part has no rounding error.
inline Reduced reduce_angle(double x) {
  if (!(std::abs(x) < kMediumAngle)) return reduce_large(x);
  constexpr double kTwoOverPi = 6.36619772367581382433e-01;
  constexpr double kPart1 = 1.57079632673412561417e+00;
  constexpr double kRest1 = 6.07710050650619224932e-11;
  const double fn = round_to_even(x * kTwoOverPi);
  const double t = x - fn * kPart1;
  const double w = fn * kRest1;
  const double hi = t - w;
  if (std::abs(hi) < 0x1p-8 && fn != 0.0) return reduce_near_multiple(x, fn);
  return {{hi, (t - hi) - w}, static_cast<std::int64_t>(fn)};
}

// sin(r) for |r| <= pi/4 and a little.
inline double sin_kernel(Pair r) {
  constexpr double S1 = -1.66666666666666324348e-01, S2 = 8.33333333332248946124e-03,
                   S3 = -1.98412698298579493134e-04, S4 = 2.75573137070700676789e-06,
                   S5 = -2.50507602534068634195e-08, S6 = 1.58969099521155010221e-10;
  const double z = r.hi * r.hi;
  const double v = z * r.hi;
  const double p = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  return r.hi - ((z * (0.5 * r.lo - v * p) - r.lo) - v * S1);
}

// cos(r) for |r| <= pi/4 and a little.
inline double cos_kernel(Pair r) {
  constexpr double C1 = 4.16666666666666019037e-02, C2 = -1.38888888888741095749e-03,
                   C3 = 2.48015872894767294178e-05, C4 = -2.75573143513906633035e-07,
                   C5 = 2.08757232129817482790e-09, C6 = -1.13596475577881948265e-11;
  const double z = r.hi * r.hi;
  const double p = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
  const double half = 0.5 * z;
  const double w = 1.0 - half;
  return w + (((1.0 - w) - half) + (z * p - r.hi * r.lo));
}

// Sine and cosine of any angle; inline because the recursions of the arm spend their time here.
inline SinCos sincos_inline(double x) {
  const Reduced a = reduce_angle(x);
  const double s = sin_kernel(a.r);
  const double c = cos_kernel(a.r);
  const bool swap = (a.quadrant & 1) != 0;
  const double sine = swap ? c : s;
  const double cosine = swap ? s : c;
  return {(a.quadrant & 2) != 0 ? -sine : sine, ((a.quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

}  // namespace armlet::det
