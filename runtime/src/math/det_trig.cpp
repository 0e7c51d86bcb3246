#include <array>
#include <limits>

#include "det_kernels.hpp"

namespace armlet::det {
namespace {

__extension__ using Uint128 = unsigned __int128;

// Bits of 2/pi after a word of zeros, most significant first; enough for the largest double.
constexpr std::array<std::uint64_t, 20> kTwoOverPiBits = {
    0,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
};

// A 192-bit number, most significant word first.
using Words = std::array<std::uint64_t, 3>;

// 192 bits of the table from the given bit on.
Words table_bits(int first_bit) {
  const std::size_t word = static_cast<std::size_t>(first_bit / 64);
  const int shift = first_bit % 64;
  Words bits{};
  for (std::size_t i = 0; i < 3; ++i) {
    bits[i] = kTwoOverPiBits[word + i] << shift;
    if (shift != 0) bits[i] |= kTwoOverPiBits[word + i + 1] >> (64 - shift);
  }
  return bits;
}

// The lower 192 bits of m * b.
Words multiply(std::uint64_t m, const Words& b) {
  const Uint128 low = static_cast<Uint128>(m) * b[2];
  const Uint128 middle = static_cast<Uint128>(m) * b[1] + static_cast<std::uint64_t>(low >> 64);
  const std::uint64_t high = m * b[0] + static_cast<std::uint64_t>(middle >> 64);
  return {high, static_cast<std::uint64_t>(middle), static_cast<std::uint64_t>(low)};
}

Words shift_left(const Words& a, int bits) {
  if (bits == 0) return a;
  if (bits >= 64) return shift_left({a[1], a[2], 0}, bits - 64);
  return {a[0] << bits | a[1] >> (64 - bits), a[1] << bits | a[2] >> (64 - bits), a[2] << bits};
}

Words negate(const Words& a) {
  Words r = {~a[0], ~a[1], ~a[2]};
  for (int i = 2; i >= 0 && ++r[static_cast<std::size_t>(i)] == 0; --i) {
  }
  return r;
}

// A 192-bit fraction in [0, 1) as a pair of doubles.
Pair to_pair(const Words& fraction) {
  int zeros = 0;
  for (std::size_t i = 0; i < 3 && zeros == static_cast<int>(64 * i); ++i) {
    zeros += std::countl_zero(fraction[i]);
  }
  if (zeros >= 128) return {};
  const Words a = shift_left(fraction, zeros);
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - zeros) << 52);
  const double hi = static_cast<double>(a[0] >> 11) * 0x1p-53;
  const double lo = static_cast<double>((a[0] & 0x7ff) << 42 | a[1] >> 22) * 0x1p-106;
  return {hi * scale, lo * scale};
}

}  // namespace

Reduced reduce_near_multiple(double x, double fn) {
  constexpr double kPart2 = 6.07710050630396597660e-11;
  constexpr double kPart3 = 2.02226624871116645580e-21;
  constexpr double kRest3 = 8.47842766036889956997e-32;
  const Pair a = two_sum(x - fn * SinCosNumbers::part1, -fn * kPart2);
  const Pair b = two_sum(a.hi, -fn * kPart3);
  const Pair r = fast_two_sum(b.hi, (a.lo + b.lo) - fn * kRest3);
  return {r, static_cast<std::int64_t>(fn)};
}

// Payne and Hanek (1983): the bits of 2/pi that contribute whole revolutions are never multiplied.
Reduced reduce_large(double x) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(x)) return {{kNaN, kNaN}, 0};
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1075;
  const std::uint64_t mantissa = (bits & 0xfffffffffffff) | 0x10000000000000;

  const Words product = multiply(mantissa, table_bits(exponent - 2 + 64));
  std::int64_t quadrant = static_cast<std::int64_t>(product[0] >> 62);
  Words fraction = shift_left(product, 2);
  const bool round_up = fraction[0] >> 63 != 0;
  if (round_up) {
    ++quadrant;
    fraction = negate(fraction);
  }
  const Pair f = to_pair(fraction);

  constexpr Pair kHalfPi = {1.57079632679489655800e+00, 6.12323399573676603587e-17};
  const Pair product_hi = two_product(f.hi, kHalfPi.hi);
  Pair r = fast_two_sum(product_hi.hi, product_hi.lo + (f.hi * kHalfPi.lo + f.lo * kHalfPi.hi));
  const bool negative = std::signbit(x);
  if (round_up != negative) r = {-r.hi, -r.lo};
  return {r, negative ? 4 - quadrant : quadrant};
}

SinCos sincos(double x) { return sincos_inline(x); }
double sin(double x) { return sincos_inline(x).sin; }
double cos(double x) { return sincos_inline(x).cos; }

void sincos(const double* x, double* s, double* c, int n) {
  int i = 0;
  for (; i + 1 < n; i += 2) sincos_pair(x + i, s + i, c + i);
  if (i < n) {
    const SinCos last = sincos_inline(x[i]);
    s[i] = last.sin;
    c[i] = last.cos;
  }
}

namespace {

// tan(r), or -1/tan(r) if inverse, for |r| <= pi/4 and a little.
double tan_kernel(Pair r, bool inverse) {
  constexpr std::array<double, 13> T = {
      3.33333333333334091986e-01, 1.33333333333201242699e-01, 5.39682539762260521377e-02,
      2.18694882948595424599e-02, 8.86323982359930005737e-03, 3.59207910759131235356e-03,
      1.45620945432529025516e-03, 5.88041240820264096874e-04, 2.46463134818469906812e-04,
      7.81794442939557092300e-05, 7.14072491382608190305e-05, -1.85586374855275456654e-05,
      2.59073051863633712884e-05};
  constexpr Pair kQuarterPi = {7.85398163397448278999e-01, 3.06161699786838301793e-17};
  const bool big = std::abs(r.hi) >= 0.67434;
  const bool negative = r.hi < 0.0;
  double x = r.hi;
  double y = r.lo;
  if (big) {
    x = (kQuarterPi.hi - std::abs(x)) + (kQuarterPi.lo - (negative ? -y : y));
    y = 0.0;
  }
  const double z = x * x;
  const double w = z * z;
  const double odd = T[1] + w * (T[3] + w * (T[5] + w * (T[7] + w * (T[9] + w * T[11]))));
  const double even = z * (T[2] + w * (T[4] + w * (T[6] + w * (T[8] + w * (T[10] + w * T[12])))));
  const double cube = z * x;
  const double rest = y + z * (cube * (odd + even) + y) + cube * T[0];
  const double t = x + rest;
  if (big) {
    const double sign = inverse ? -1.0 : 1.0;
    const double value = sign - 2.0 * (x + (rest - t * t / (t + sign)));
    return negative ? -value : value;
  }
  if (!inverse) return t;
  // -1 / (x + rest) loses a digit when computed directly.
  const double t0 = upper_half(t);
  const double remainder = rest - (t0 - x);
  const double a = -1.0 / t;
  const double a0 = upper_half(a);
  return a0 + a * (1.0 + a0 * t0 + a0 * remainder);
}

}  // namespace

double tan(double x) {
  const Reduced a = reduce_angle(x);
  return tan_kernel(a.r, (a.quadrant & 1) != 0);
}

}  // namespace armlet::det
