#include <array>
#include <limits>

#include "det_kernels.hpp"

namespace armlet::det {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLn2Hi = 6.93147180369123816490e-01;  // 33 bits
constexpr double kLn2Lo = 1.90821492927058770002e-10;

// y * 2^k with a single rounding, for 0.5 <= y <= 2 and -1080 <= k <= 1024.
double scale_by_power(double y, int k) {
  const auto power = [](int e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  };
  if (k > 1023) return y * 0x1p1023 * power(k - 1023);
  if (k >= -1022) return y * power(k);
  return y * power(k + 100) * 0x1p-100;
}

// exp(x.hi + x.lo).
double exp_pair(Pair x) {
  if (std::isnan(x.hi)) return x.hi;
  if (x.hi > 709.79) return kInfinity;
  if (x.hi < -745.2) return 0.0;
  constexpr double P1 = 1.66666666666666019037e-01, P2 = -2.77777777770155933842e-03,
                   P3 = 6.61375632143793436117e-05, P4 = -1.65339022054652515390e-06,
                   P5 = 4.13813679705723846039e-08;
  const double fk = round_to_even(x.hi * 1.44269504088896338700e+00);
  const double hi = x.hi - fk * kLn2Hi;
  const double lo = fk * kLn2Lo - x.lo;
  const double r = hi - lo;
  const double z = r * r;
  const double c = r - z * (P1 + z * (P2 + z * (P3 + z * (P4 + z * P5))));
  const double y = 1.0 - ((lo - (r * c) / (2.0 - c)) - hi);
  return scale_by_power(y, static_cast<int>(fk));
}

// x = m * 2^k with m in [sqrt(1/2), sqrt(2)), for finite x > 0.
struct Scaled {
  double m = 0.0;
  int k = 0;
};

Scaled split_power(double x) {
  int k = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    k = -54;
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  k += static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0xfffffffffffff) | 0x3ff0000000000000);
  if (m >= 1.41421356237309504880) {
    m *= 0.5;
    ++k;
  }
  return {m, k};
}

// a * b for pairs, with a relative error of about 2^-103.
Pair multiply(Pair a, Pair b) {
  const Pair p = two_product(a.hi, b.hi);
  return fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

Pair add(Pair a, Pair b) {
  const Pair s = two_sum(a.hi, b.hi);
  return fast_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

// log(x) to about 65 bits: log m = 2 s (1 + s^2/3 + s^4/5 + ...), s = (m - 1)/(m + 1).
Pair log_pair(double x) {
  const Scaled scaled = split_power(x);
  const double f = scaled.m - 1.0;
  const Pair d = two_sum(scaled.m, 1.0);
  const double s_hi = f / d.hi;
  const Pair back = two_product(s_hi, d.hi);
  const Pair s = {s_hi, (((f - back.hi) - back.lo) - s_hi * d.lo) / d.hi};

  const Pair z = multiply(s, s);
  double series = 0.0;
  for (int odd = 29; odd >= 5; odd -= 2) series = 1.0 / odd + z.hi * series;
  constexpr Pair kThird = {1.0 / 3.0, 1.850371707708594e-17};
  const Pair u = multiply(z, add(kThird, {z.hi * series, 0.0}));
  const Pair su = multiply(s, u);
  const Pair log_m = add({2.0 * s.hi, 2.0 * s.lo}, {2.0 * su.hi, 2.0 * su.lo});

  constexpr double kLn2Rest = -1.90465429995776804525e-09;  // ln 2 = kLn2Head + kLn2Rest
  constexpr double kLn2Head = 6.93147182464599609375e-01;   // 24 bits
  constexpr double kLn2Tail = 1.66708592083055e-25;         // the rest of ln 2
  const double k = scaled.k;
  const Pair rest = two_product(k, kLn2Rest);
  const Pair k_ln2 = add({k * kLn2Head, 0.0}, {rest.hi, rest.lo + k * kLn2Tail});
  return add(k_ln2, log_m);
}

enum class Parity { kNotInteger, kEven, kOdd };

Parity parity_of(double y) {
  const double a = std::abs(y);
  if (a >= 0x1p53) return Parity::kEven;
  const double whole = static_cast<double>(static_cast<std::int64_t>(a));
  if (whole != a) return Parity::kNotInteger;
  return (static_cast<std::int64_t>(a) & 1) != 0 ? Parity::kOdd : Parity::kEven;
}

// x^y for x > 0, both finite.
double pow_positive(double x, double y) {
  const Pair log_x = log_pair(x);
  const double rough = y * log_x.hi;
  if (rough > 710.0) return kInfinity;
  if (rough < -746.0) return 0.0;
  if (std::abs(y) < 0x1p-500) return 1.0;
  const Pair p = two_product(y, log_x.hi);
  return exp_pair(fast_two_sum(p.hi, p.lo + y * log_x.lo));
}

}  // namespace

double exp(double x) { return exp_pair({x, 0.0}); }

double log(double x) {
  if (std::isnan(x) || x < 0.0) return kNaN;
  if (x == 0.0) return -kInfinity;
  if (std::isinf(x)) return x;
  constexpr std::array<double, 7> L = {6.666666666666735130e-01, 3.999999999940941908e-01,
                                       2.857142874366239149e-01, 2.222219843214978396e-01,
                                       1.818357216161805012e-01, 1.531383769920937332e-01,
                                       1.479819860511658591e-01};
  const Scaled scaled = split_power(x);
  const double f = scaled.m - 1.0;
  const double half_square = 0.5 * f * f;
  const double s = f / (2.0 + f);
  const double z = s * s;
  const double w = z * z;
  const double even = w * (L[1] + w * (L[3] + w * L[5]));
  const double odd = z * (L[0] + w * (L[2] + w * (L[4] + w * L[6])));
  const double k = scaled.k;
  return s * (half_square + (odd + even)) + k * kLn2Lo - half_square + f + k * kLn2Hi;
}

double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const double ax = std::abs(x);
  if (std::isinf(y)) {
    if (ax == 1.0) return 1.0;
    return (ax > 1.0) == (y > 0.0) ? kInfinity : 0.0;
  }
  const Parity parity = parity_of(y);
  const double sign = std::signbit(x) && parity == Parity::kOdd ? -1.0 : 1.0;
  if (ax == 0.0 || std::isinf(ax)) return sign * ((ax == 0.0) == (y > 0.0) ? 0.0 : kInfinity);
  if (x < 0.0 && parity == Parity::kNotInteger) return kNaN;
  return sign * pow_positive(ax, y);
}

}  // namespace armlet::det
