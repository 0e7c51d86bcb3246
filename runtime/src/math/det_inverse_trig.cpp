#include <array>
#include <limits>

#include "det_kernels.hpp"

namespace armlet::det {
namespace {

constexpr Pair kHalfPi = {1.57079632679489655800e+00, 6.12323399573676603587e-17};
constexpr Pair kPi = {3.14159265358979311600e+00, 1.22464679914735320717e-16};

// atan(x + tail) for x >= 0 as an unevaluated sum.
Pair atan_kernel(double x, double tail) {
  constexpr std::array<double, 11> A = {
      3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
      -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
      6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
      -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  constexpr std::array<Pair, 4> kBase = {
      {{4.63647609000806093515e-01, 2.26987774529616870924e-17},
       {7.85398163397448278999e-01, 3.06161699786838301793e-17},
       {9.82793723247329054082e-01, 1.39033110312309984516e-17},
       {1.57079632679489655800e+00, 6.12323399573676603587e-17}}};
  if (x >= 0x1p66) return kBase[3];
  const double correction = tail / (1.0 + x * x);
  int piece = -1;
  double t = x;
  if (x >= 2.4375) {
    piece = 3;
    t = -1.0 / x;
  } else if (x >= 1.1875) {
    piece = 2;
    t = (x - 1.5) / (1.0 + 1.5 * x);
  } else if (x >= 0.6875) {
    piece = 1;
    t = (x - 1.0) / (x + 1.0);
  } else if (x >= 0.4375) {
    piece = 0;
    t = (2.0 * x - 1.0) / (2.0 + x);
  }
  const double z = t * t;
  const double w = z * z;
  const double even = z * (A[0] + w * (A[2] + w * (A[4] + w * (A[6] + w * (A[8] + w * A[10])))));
  const double odd = w * (A[1] + w * (A[3] + w * (A[5] + w * (A[7] + w * A[9]))));
  const double bent = t * (even + odd);
  if (piece < 0) return {t, correction - bent};
  const Pair base = kBase[static_cast<std::size_t>(piece)];
  return {base.hi, t - ((bent - base.lo) - correction)};
}

// (asin(sqrt(z)) - sqrt(z)) / sqrt(z) for 0 <= z <= 1/4.
double asin_rational(double z) {
  constexpr double p0 = 1.66666666666666657415e-01, p1 = -3.25565818622400915405e-01,
                   p2 = 2.01212532134862925881e-01, p3 = -4.00555345006794114027e-02,
                   p4 = 7.91534994289814532176e-04, p5 = 3.47933107596021167570e-05,
                   q1 = -2.40339491173441421878e+00, q2 = 2.02094576023350569471e+00,
                   q3 = -6.88283971605453293030e-01, q4 = 7.70381505559019352791e-02;
  const double p = z * (p0 + z * (p1 + z * (p2 + z * (p3 + z * (p4 + z * p5)))));
  const double q = 1.0 + z * (q1 + z * (q2 + z * (q3 + z * q4)));
  return p / q;
}

}  // namespace

double atan(double x) {
  if (std::isnan(x)) return x;
  const Pair a = atan_kernel(std::abs(x), 0.0);
  const double value = a.hi + a.lo;
  return std::signbit(x) ? -value : value;
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  Pair a;
  if (ay == 0.0) {
    a = {0.0, 0.0};
  } else if (ax == 0.0 || ay > ax * 0x1p70) {
    a = kHalfPi;
  } else if (std::isinf(ax)) {
    a = std::isinf(ay) ? Pair{0.5 * kHalfPi.hi, 0.5 * kHalfPi.lo} : Pair{};
  } else {
    const double q = ay / ax;
    // The rounding error of the quotient; it matters only where the products cannot overflow.
    const bool ordinary = ax < 0x1p500 && ay < 0x1p500 && ax > 0x1p-500 && q > 0x1p-100;
    const Pair back = ordinary ? two_product(q, ax) : Pair{ay, 0.0};
    a = atan_kernel(q, ((ay - back.hi) - back.lo) / ax);
  }
  double value = a.hi + a.lo;
  if (std::signbit(x)) {
    const Pair s = two_sum(kPi.hi, -a.hi);
    value = s.hi + (s.lo + (kPi.lo - a.lo));
  }
  return std::signbit(y) ? -value : value;
}

double asin(double x) {
  const double ax = std::abs(x);
  if (!(ax <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (ax < 0.5) return x + x * asin_rational(x * x);
  const double z = (1.0 - ax) * 0.5;
  const double s = std::sqrt(z);
  const double r = asin_rational(z);
  double value = 0.0;
  if (ax > 0.975) {
    value = kHalfPi.hi - (2.0 * (s + s * r) - kHalfPi.lo);
  } else {
    const double f = upper_half(s);
    const double c = (z - f * f) / (s + f);
    const double quarter = 0.5 * kHalfPi.hi;
    value = quarter - ((2.0 * s * r - (kHalfPi.lo - 2.0 * c)) - (quarter - 2.0 * f));
  }
  return std::signbit(x) ? -value : value;
}

double acos(double x) {
  if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (x == 1.0) return 0.0;
  if (std::abs(x) < 0.5) return kHalfPi.hi - (x - (kHalfPi.lo - x * asin_rational(x * x)));
  if (x < 0.0) {
    const double z = (1.0 + x) * 0.5;
    const double s = std::sqrt(z);
    return 2.0 * (kHalfPi.hi - (s + (asin_rational(z) * s - kHalfPi.lo)));
  }
  const double z = (1.0 - x) * 0.5;
  const double s = std::sqrt(z);
  const double f = upper_half(s);
  const double c = (z - f * f) / (s + f);
  return 2.0 * (f + (asin_rational(z) * s + c));
}

double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace armlet::det
