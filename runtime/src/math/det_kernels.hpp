#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "armlet/math/det_math.hpp"
#include "det_lanes.hpp"

// Building blocks of det_math: exact sums and products, argument reduction.
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

// a + b exactly, for |a| >= |b| (Dekker).
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

Reduced reduce_large(double x);                     // any finite |x|
Reduced reduce_near_multiple(double x, double fn);  // fn pi/2 is very close to x

inline double round_to_even(double x) { return (x + kRoundingMagic) - kRoundingMagic; }

inline Reduced reduce_angle(double x) {
  const double fn = round_to_even(x * kTwoOverPi);
  const double allowed = fn * kNearestMultiple;
  const double allowed2 = allowed * allowed;
  if (!(allowed2 < kFarthestMultiple)) return reduce_large(x);
  const auto [hi, lo] = subtract_right_angles(x, fn);
  if (!(allowed2 <= hi * hi)) return reduce_near_multiple(x, fn);
  return {{hi, lo}, static_cast<std::int64_t>(fn)};
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
inline void sincos_pair(const double* x, double* s, double* c) {
  LaneCheck<Lanes> check;
  const LaneSinCos<Lanes> both = sincos_lanes(Lanes{x[0], x[1]}, check);
  const bool settled = check.all_settled();
  for (int k = 0; k < 2; ++k) {
    const SinCos one = settled ? SinCos{both.sin[k], both.cos[k]} : sincos_inline(x[k]);
    s[k] = one.sin;
    c[k] = one.cos;
  }
}

}  // namespace armlet::det
