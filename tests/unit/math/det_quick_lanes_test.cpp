#include "math/det_quick_lanes.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

#include "armlet/core/random.hpp"
#include "armlet/math/det_math.hpp"

using namespace armlet;

namespace {

using det::Lanes;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kRightAngle = 1.5707963267948966;
constexpr double kLargest = 402.0;  // rad; a little below 2^8 right angles

using EightAngles = std::array<double, 8>;

struct EightSines {
  std::array<det::SinCos, 8> turns;
  bool any_too_large;
};

EightSines quick_angles(const EightAngles& x) {
  const det::QuickTable<Lanes> table;
  det::QuickCheck<Lanes> check;
  const det::FourLanes<Lanes> angles = {{x[0], x[1]}, {x[2], x[3]}, {x[4], x[5]}, {x[6], x[7]}};
  const auto [a, b, c, d] = det::quick_sincos(angles, check, table);
  EightSines result{.turns = {}, .any_too_large = check.any_too_large()};
  for (std::size_t k = 0; k < 8; ++k) {
    const auto& pair = k < 2 ? a : k < 4 ? b : k < 6 ? c : d;
    result.turns[k] = {pair.sin[k % 2], pair.cos[k % 2]};
  }
  return result;
}

// Distances from the 80-bit results of the C library: the largest in units of 2^-53 of the value,
// whatever is below 2^-91 not counted, and the largest of all.
struct Errors {
  double relative = 0.0, absolute = 0.0;

  void add(double value, long double exact) {
    const double error = static_cast<double>(std::abs(static_cast<long double>(value) - exact));
    absolute = std::max(absolute, error);
    const double size = static_cast<double>(std::abs(exact));
    relative = std::max(relative, (error - 0x1p-91) / (0x1p-53 * size));
  }

  void add(const EightAngles& x) {
    const EightSines result = quick_angles(x);
    CHECK(!result.any_too_large);
    for (std::size_t k = 0; k < 8; ++k) {
      add(result.turns[k].sin, std::sin(static_cast<long double>(x[k])));
      add(result.turns[k].cos, std::cos(static_cast<long double>(x[k])));
    }
  }
};

double of_any_size(Random& random) {
  const int exponent = static_cast<int>(random.below(2000)) - 1000;
  return std::ldexp(random.uniform(-2.0, 2.0), exponent);
}

}  // namespace

TEST_CASE("quick sines and cosines are within two units in the last place") {
  Random random(1);
  for (const double range : {0.8, 7.0, 40.0, kLargest}) {
    CAPTURE(range);
    Errors errors;
    for (int k = 0; k < 50'000; ++k) {
      EightAngles x;
      for (double& angle : x) angle = random.uniform(-range, range);
      errors.add(x);
    }
    CHECK(errors.relative < 3.0);
    CHECK(errors.absolute < 0x1p-52);
  }
  Errors errors;  // side by side over a whole revolution
  for (int k = 0; k < 50'000; ++k) {
    EightAngles x;
    for (std::size_t i = 0; i < 8; ++i) x[i] = (8.0 * k + static_cast<double>(i)) * 1.6e-5;
    errors.add(x);
  }
  CHECK(errors.relative < 3.0);
  CHECK(errors.absolute < 0x1p-52);
}

TEST_CASE("quick sines and cosines keep their digits at multiples of a right angle") {
  Errors errors;
  for (int multiple = -255; multiple <= 255; ++multiple) {
    for (const double step : {kRightAngle, 0.5 * kRightAngle}) {
      const double middle = multiple * step;
      EightAngles x = {middle,
                       std::nextafter(middle, kInf),
                       std::nextafter(middle, -kInf),
                       middle + 1e-12,
                       middle - 1e-12,
                       middle + 1e-7,
                       middle - 1e-7,
                       middle + 1e-3};
      errors.add(x);
    }
  }
  CHECK(errors.relative < 3.0);
  CHECK(errors.absolute < 0x1p-52);
  const det::SinCos zero = quick_angles({}).turns[0];
  CHECK(zero.sin == 0.0);
  CHECK(zero.cos == 1.0);
}

TEST_CASE("an angle that is too large or not finite is noticed in any lane") {
  constexpr double kHuge = std::numeric_limits<double>::max();
  const double too_large[] = {402.2,  1e3,     411774.0, 4e15, 4503599627370496.0,
                              7.1e15, 1.06e16, 1.5e16,   1e18, 1e300,
                              kHuge,  kInf,    NAN};
  for (std::size_t lane = 0; lane < 8; ++lane) {
    CAPTURE(lane);
    for (const double size : too_large) {
      for (const double angle : {size, -size}) {
        CAPTURE(angle);
        CHECK(det::is_too_large(angle));
        EightAngles x = {0.1, -0.2, 0.0, 3.0, -3.0, 401.0, -401.0, 1.0};
        x[lane] = angle;
        CHECK(quick_angles(x).any_too_large);
      }
    }
  }
  Random random(3);
  bool right = true;
  for (int k = 0; k < 200'000; ++k) {
    EightAngles x{};
    const double angle = x[random.below(8)] = of_any_size(random);
    right = right && det::is_too_large(angle) == quick_angles(x).any_too_large &&
            (std::abs(angle) < kLargest || std::abs(angle) > 402.13 ||
             det::is_too_large(angle) == (std::abs(angle) >= 256 * kRightAngle));
  }
  CHECK(right);
}

TEST_CASE("prompt sines and cosines are as good, and notice the same angles") {
  const det::QuickTable<Lanes> table;
  Random random(4);
  Errors errors;
  bool right = true;
  const auto add = [&](double angle) {
    det::QuickCheck<Lanes> check;
    const auto turn = det::prompt_sincos(Lanes{0.5, angle}, check, table);
    right = right && check.any_too_large() == det::is_too_large(angle);
    if (det::is_too_large(angle)) return;
    errors.add(turn.sin[1], std::sin(static_cast<long double>(angle)));
    errors.add(turn.cos[1], std::cos(static_cast<long double>(angle)));
  };
  for (const double range : {0.8, 7.0, kLargest, 1000.0}) {
    for (int k = 0; k < 50'000; ++k) add(random.uniform(-range, range));
  }
  for (int multiple = -255; multiple <= 255; ++multiple) {
    const double middle = 0.5 * multiple * kRightAngle;
    for (const double offset : {0.0, 1e-15, -1e-12, 1e-7, -1e-3}) add(middle + offset);
  }
  for (const double angle : {kInf, -kInf, std::numeric_limits<double>::quiet_NaN(), 1e300})
    add(angle);
  CHECK(right);
  CHECK(errors.relative < 3.0);
  CHECK(errors.absolute < 0x1p-52);
}
