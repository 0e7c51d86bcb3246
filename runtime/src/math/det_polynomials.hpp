#pragma once

// Reduction and polynomials of sine and cosine, for one number or for lanes of numbers.
// The polynomials and their coefficients are those of fdlibm (Sun Microsystems, 1993), which may be
// used freely provided that its notice is preserved:
//   Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved. Developed at SunSoft, a Sun
//   Microsystems, Inc. business. Permission to use, copy, modify, and distribute this software is
//   freely granted, provided that this notice is preserved.
namespace armlet::det {

inline constexpr double kTwoOverPi = 6.36619772367581382433e-01;

// 1.5 * 2^52: adding and subtracting this number rounds a double below 2^51 to the nearest integer,
// ties to even.
inline constexpr double kRoundingMagic = 6755399441055744.0;

// The constants of range reduction and polynomials.
//
// part1, part2, rest2  Cody and Waite: pi/2 in two parts of 33 bits and a rest, so that whole
//                      multiples below 2^14 of the parts have no rounding error and those of the
//                      rest stay below half a unit in the last place.
struct SinCosNumbers {
  static constexpr double part1 = 1.57079632673412561417e+00, part2 = 6.07710050630396597660e-11,
                          rest2 = 2.02226624879595063154e-21;
  static constexpr double S1 = -1.66666666666666324348e-01, S2 = 8.33333333332248946124e-03,
                          S3 = -1.98412698298579493134e-04, S4 = 2.75573137070700676789e-06,
                          S5 = -2.50507602534068634195e-08, S6 = 1.58969099521155010221e-10;
  static constexpr double C1 = 4.16666666666666019037e-02, C2 = -1.38888888888741095749e-03,
                          C3 = 2.48015872894767294178e-05, C4 = -2.75573143513906633035e-07,
                          C5 = 2.08757232129817482790e-09, C6 = -1.13596475577881948265e-11;
};

// The parts represent pi/2 to 2^-121, so fn pi/2 is exact enough for a difference of fn 2^-62. Both
// bounds hold if (fn 2^-62)^2 is at most the square of the difference and below (2^14 2^-62)^2.
// Lanes are checked more strictly (det_lanes.hpp), so they never differ from single numbers.
inline constexpr double kNearestMultiple = 0x1p-62;
inline constexpr double kFarthestMultiple = 0x1p-96;

// x - fn pi/2 as an unevaluated sum.
template <class Number>
struct Difference {
  Number hi, lo;
};

template <class Number>
[[gnu::always_inline]] inline Difference<Number> subtract_right_angles(Number x, Number fn) {
  using N = SinCosNumbers;
  const Number t = x - fn * N::part1;  // exact
  const Number w = fn * N::part2;      // exact
  const Number hi = t - w;
  return {hi, ((t - hi) - w) - fn * N::rest2};
}

// sin(hi + lo) for |hi| <= pi/4 and a little.
template <class Number>
[[gnu::always_inline]] inline Number sin_kernel(Number hi, Number lo) {
  using N = SinCosNumbers;
  const Number z = hi * hi;
  const Number v = z * hi;
  const Number p = N::S2 + z * (N::S3 + z * (N::S4 + z * (N::S5 + z * N::S6)));
  return hi - ((0.5 * z * lo - lo) - v * (N::S1 + z * p));
}

// cos(hi + lo) for |hi| <= pi/4 and a little.
template <class Number>
[[gnu::always_inline]] inline Number cos_kernel(Number hi, Number lo) {
  using N = SinCosNumbers;
  const Number z = hi * hi;
  const Number p = z * (N::C1 + z * (N::C2 + z * (N::C3 + z * (N::C4 + z * (N::C5 + z * N::C6)))));
  const Number half = 0.5 * z;
  const Number w = 1.0 - half;
  return w + (((1.0 - w) - half) + (z * p - hi * lo));
}

}  // namespace armlet::det
