#include "armlet/math/det_math.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "armlet/core/random.hpp"

using namespace armlet;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

// Distance of a value from the 80-bit result of the C library, in units in the last place.
double error_ulp(double value, long double exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double next = std::nextafter(rounded, kInf);
  const long double ulp = static_cast<long double>(next) - static_cast<long double>(rounded);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / ulp);
}

// Worst error of f against g over random arguments drawn by `draw`.
template <class F, class G, class Draw>
double worst_error(F f, G g, Draw draw, int count) {
  Random random(1);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = draw(random);
    worst = std::max(worst, error_ulp(f(x), g(static_cast<long double>(x))));
  }
  return worst;
}

auto between(double low, double high) {
  return [=](Random& random) { return random.uniform(low, high); };
}

// A number with a random exponent of two.
auto of_any_size(int low, int high) {
  return [=](Random& random) {
    const int e = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
    return std::ldexp(random.uniform(1.0, 2.0), e) * (random.below(2) == 0 ? 1.0 : -1.0);
  };
}

const auto kSinL = [](long double x) { return std::sin(x); };
const auto kCosL = [](long double x) { return std::cos(x); };
const auto kTanL = [](long double x) { return std::tan(x); };
const auto kExpL = [](long double x) { return std::exp(x); };
const auto kLogL = [](long double x) { return std::log(x); };

}  // namespace

// The x87 long double functions of glibc are accurate to about 2^-63 of the result, which is 1/1000
// of a unit in the last place of a double.
TEST_CASE("sine, cosine and tangent are within one unit in the last place") {
  for (const double range : {0.8, 7.0, 100.0, 1e5}) {
    CAPTURE(range);
    CHECK(worst_error(det::sin, kSinL, between(-range, range), 400'000) < 0.85);
    CHECK(worst_error(det::cos, kCosL, between(-range, range), 400'000) < 0.85);
    CHECK(worst_error(det::tan, kTanL, between(-range, range), 200'000) < 1.0);
  }
}

// glibc's long double reduction loses bits close to multiples of pi/2 beyond 2^63, not before.
TEST_CASE("angles of any size are reduced exactly") {
  CHECK(worst_error(det::sin, kSinL, of_any_size(-40, 60), 300'000) < 0.85);
  CHECK(worst_error(det::cos, kCosL, of_any_size(-40, 60), 300'000) < 0.85);
  CHECK(worst_error(det::sin, kSinL, of_any_size(60, 1023), 100'000) < 0.85);
  // W. Kahan's hardest case: the double nearest to a multiple of pi/2.
  const double x = std::ldexp(6381956970095103.0, 797);
  CHECK(det::cos(x) == doctest::Approx(-4.68716592425462761112e-19).epsilon(1e-15));
  CHECK(error_ulp(det::cos(x), -4.68716592425462761112e-19L) < 1.0);
}

TEST_CASE("multiples of a right angle keep full relative accuracy") {
  double worst = 0.0;
  for (int k = 1; k < 200'000; ++k) {
    const double x = k * 1.57079632679489661923;
    worst = std::max(worst, error_ulp(det::sin(x), std::sin(static_cast<long double>(x))));
    worst = std::max(worst, error_ulp(det::cos(x), std::cos(static_cast<long double>(x))));
  }
  CHECK(worst < 0.85);
}

// Pairs of ordinary angles with those that a vectorised reduction has to leave open: zero, exact
// multiples of a right angle, huge ones, and what is not finite.
TEST_CASE("the batch gives the same bits as single calls") {
  const double specials[] = {
      0.0,   -0.0, 1e-300, 1.5707963267948966, -3.141592653589793, 411774.0, 411775.5, -1e9,
      1e300, kInf, NAN};
  Random random(7);
  for (int k = 0; k < 20'000; ++k) {
    double x[11], s[11], c[11];
    for (double& value : x) {
      value = random.below(4) == 0 ? specials[random.below(std::size(specials))]
                                   : of_any_size(-30, 25)(random);
    }
    const int n = static_cast<int>(random.below(12));
    det::sincos(x, s, c, n);
    bool same = true;
    for (int i = 0; i < n; ++i) {
      const bool is_nan = std::isnan(s[i]) && std::isnan(c[i]) && !std::isfinite(x[i]);
      same = same && (is_nan || (std::bit_cast<std::uint64_t>(s[i]) ==
                                     std::bit_cast<std::uint64_t>(det::sin(x[i])) &&
                                 c[i] == det::cos(x[i]) && det::sincos(x[i]).sin == s[i]));
    }
    CHECK(same);
  }
}

TEST_CASE("inverse functions are within one unit in the last place") {
  CHECK(worst_error(
            det::asin, [](long double x) { return std::asin(x); }, between(-1, 1), 1'000'000) <
        1.0);
  CHECK(worst_error(
            det::acos, [](long double x) { return std::acos(x); }, between(-1, 1), 1'000'000) <
        1.0);
  CHECK(worst_error(
            det::atan, [](long double x) { return std::atan(x); }, between(-5, 5), 1'000'000) <
        1.0);
  CHECK(worst_error(
            det::atan, [](long double x) { return std::atan(x); }, of_any_size(-60, 60), 500'000) <
        1.0);
  Random random(3);
  double worst = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double y = of_any_size(-20, 20)(random);
    const double x = of_any_size(-20, 20)(random);
    worst = std::max(worst, error_ulp(det::atan2(y, x), std::atan2(static_cast<long double>(y),
                                                                   static_cast<long double>(x))));
  }
  CHECK(worst < 1.0);
}

TEST_CASE("exponential, logarithm and power are within one unit in the last place") {
  CHECK(worst_error(det::exp, kExpL, between(-700, 700), 1'000'000) < 1.0);
  CHECK(worst_error(det::exp, kExpL, between(-1, 1), 500'000) < 1.0);
  const auto positive = [](Random& random) { return std::abs(of_any_size(-1000, 1000)(random)); };
  CHECK(worst_error(det::log, kLogL, positive, 500'000) < 1.0);
  CHECK(worst_error(det::log, kLogL, between(0.5, 2), 1'000'000) < 1.0);
  Random random(5);
  double worst = 0.0;
  for (int i = 0; i < 500'000; ++i) {
    const double x = std::abs(of_any_size(-30, 30)(random));
    const double y = random.uniform(-20, 20);
    worst = std::max(worst, error_ulp(det::pow(x, y), std::pow(static_cast<long double>(x),
                                                               static_cast<long double>(y))));
  }
  for (int i = 0; i < 300'000; ++i) {  // large exponents of numbers near one
    const double x = random.uniform(0.9, 1.1);
    const double y = random.uniform(-5000, 5000);
    worst = std::max(worst, error_ulp(det::pow(x, y), std::pow(static_cast<long double>(x),
                                                               static_cast<long double>(y))));
  }
  CHECK(worst < 1.0);
}

TEST_CASE("whole powers that fit a double are exact") {
  CHECK(det::pow(10.0, 15.0) == 1e15);
  CHECK(det::pow(-3.0, 3.0) == -27.0);
  CHECK(det::pow(2.0, -1074.0) == std::numeric_limits<double>::denorm_min());
  CHECK(det::pow(1.5, 2.0) == 2.25);
}

TEST_CASE("special arguments behave as in the C library") {
  const double specials[] = {0.0, -0.0, 1.0,   -1.0, 0.5,   -2.0,
                             3.0, kInf, -kInf, NAN,  1e300, -1e-300};
  const auto same = [](double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b)) ||
           std::abs(a - b) < 1e-15 * std::abs(b);
  };
  for (const double a : specials) {
    CAPTURE(a);
    CHECK(same(det::exp(a), std::exp(a)));
    CHECK(same(det::log(a), std::log(a)));
    CHECK(same(det::atan(a), std::atan(a)));
    CHECK(same(det::asin(a), std::asin(a)));
    CHECK(same(det::acos(a), std::acos(a)));
    CHECK(std::isnan(det::sin(a)) == std::isnan(std::sin(a)));
    for (const double b : specials) {
      CAPTURE(b);
      CHECK(same(det::atan2(a, b), std::atan2(a, b)));
      CHECK(same(det::pow(a, b), std::pow(a, b)));
    }
  }
  CHECK(std::signbit(det::sin(-0.0)));
}

TEST_CASE("the bits do not change from machine to machine") {
  CHECK(std::bit_cast<std::uint64_t>(det::sin(1.0)) == 0x3feaed548f090ceeu);
  CHECK(std::bit_cast<std::uint64_t>(det::exp(1.0)) == 0x4005bf0a8b14576au);
  CHECK(std::bit_cast<std::uint64_t>(det::atan2(1.0, -1.0)) == 0x4002d97c7f3321d2u);
}
