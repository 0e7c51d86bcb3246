#include "armlet/plot/ticks.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"

using namespace armlet;
using Labels = std::vector<std::string>;

TEST_CASE("ticks are round and labelled with equal decimals") {
  CHECK(make_ticks(0, 1, 5, false, true).labels == Labels{"0", "0.2", "0.4", "0.6", "0.8", "1.0"});
  CHECK(make_ticks(-3, 7, 5, false, true).labels == Labels{"-4", "-2", "0", "2", "4", "6", "8"});
  CHECK(make_ticks(0.013, 0.0172, 4, false, false).labels ==
        Labels{"0.013", "0.014", "0.015", "0.016", "0.017"});
  CHECK(make_ticks(0, 45000, 5, false, true).labels ==
        Labels{"0", "10000", "20000", "30000", "40000", "50000"});
}

TEST_CASE("degrees are counted in parts of a revolution") {
  CHECK(make_ticks(-180, 180, 8, true, true).labels ==
        Labels{"-180", "-135", "-90", "-45", "0", "45", "90", "135", "180"});
  CHECK(make_ticks(0, 60, 6, true, true).labels == Labels{"0", "10", "20", "30", "40", "50", "60"});
}

TEST_CASE("values that are all the same get room to either side") {
  for (const double value : {0.0, 5.0, -3e7, 1e300, 1e-300}) {
    CAPTURE(value);
    const Ticks ticks = make_ticks(value, value, 5, false, true);
    CHECK(ticks.lower < value);
    CHECK(ticks.upper > value);
    CHECK(ticks.at.size() >= 2);
  }
}

TEST_CASE("whatever the values, ticks are few, increase and enclose what was asked for") {
  Random random(61);
  for (int k = 0; k < 5000; ++k) {
    const double scale = std::pow(10.0, random.uniform(-250, 280));
    const double a = scale * random.uniform(-1, 1), b = scale * random.uniform(-1, 1);
    const double lower = std::min(a, b), upper = std::max(a, b);
    const int wanted = 2 + k % 9;
    const Ticks ticks = make_ticks(lower, upper, wanted, k % 3 == 0, true);
    CHECK(ticks.lower <= lower + 1e-9 * scale);
    CHECK(ticks.upper >= upper - 1e-9 * scale);
    CHECK(ticks.at.size() >= 2);
    CHECK(ticks.at.size() <= static_cast<std::size_t>(2 * wanted + 3));
    CHECK(ticks.at.size() == ticks.labels.size());
    for (std::size_t i = 1; i < ticks.at.size(); ++i) CHECK(ticks.at[i] > ticks.at[i - 1]);
    CHECK(std::isfinite(ticks.position(lower)));
  }
}

TEST_CASE("a logarithmic axis has powers of ten, and 1, 2, 5 where it is short") {
  CHECK(make_log_ticks(0.02, 300, 6).labels == Labels{"0.01", "0.1", "1", "10", "100", "1000"});
  CHECK(make_log_ticks(3, 40, 6).labels == Labels{"2", "5", "10", "20", "50"});
  CHECK(make_log_ticks(1e-9, 1e-6, 6).labels ==
        Labels{"10\u207b\u2079", "10\u207b\u2078", "10\u207b\u2077", "10\u207b\u2076"});
  const Ticks ticks = make_log_ticks(1, 1000, 6);
  CHECK(ticks.position(1) == 0.0);
  CHECK(ticks.position(1000) == 1.0);
  CHECK(ticks.position(10) == doctest::Approx(1.0 / 3));
  CHECK(ticks.minor.size() == 24);  // 2 to 9 of three powers
}

TEST_CASE("whatever the values above zero, logarithmic ticks are few, increase and enclose them") {
  Random random(63);
  for (int k = 0; k < 3000; ++k) {
    const double a = std::pow(10.0, random.uniform(-300, 300));
    const double b = k % 3 == 0   ? a
                     : k % 3 == 1 ? a * random.uniform(1, 200)
                                  : std::pow(10.0, random.uniform(-300, 300));
    const double lower = std::min(a, b), upper = std::max(a, b);
    const int wanted = 2 + k % 9;
    CAPTURE(lower);
    CAPTURE(upper);
    const Ticks ticks = make_log_ticks(lower, upper, wanted);
    CHECK(ticks.lower <= lower);
    CHECK(ticks.upper >= upper);
    CHECK(ticks.upper > ticks.lower);
    CHECK(ticks.at.size() >= 1);
    CHECK(ticks.at.size() <= static_cast<std::size_t>(wanted + 8));
    CHECK(ticks.at.size() == ticks.labels.size());
    for (std::size_t i = 1; i < ticks.at.size(); ++i) CHECK(ticks.at[i] > ticks.at[i - 1]);
    CHECK(ticks.position(lower) >= -1e-12);
    CHECK(ticks.position(upper) <= 1.0 + 1e-12);
  }
}

TEST_CASE("an axis beside another one has its ticks at the same heights, zero at zero") {
  const Ticks left = make_ticks(-180, 180, 6, true, true);
  const Ticks right = make_parallel_ticks(-0.12, 0.15, left, false);
  REQUIRE(right.at.size() == left.at.size());
  CHECK(right.position(0.0) == doctest::Approx(left.position(0.0)));
  Random random(64);
  for (int k = 0; k < 3000; ++k) {
    const double scale = std::pow(10.0, random.uniform(-20, 20));
    const auto values = [&](double size) {
      const double a = size * random.uniform(-1, 1), b = size * random.uniform(-1, 1);
      return std::pair(std::min(a, b), std::max(a, b));
    };
    const auto [l, u] = values(100.0);
    const Ticks one = make_ticks(l, u, 4 + k % 4, false, true);
    const auto [lower, upper] = values(scale);
    const Ticks other = make_parallel_ticks(lower, upper, one, false);
    CHECK(other.at.size() == one.at.size());
    CHECK(other.lower <= lower + 1e-9 * scale);
    CHECK(other.upper >= upper - 1e-9 * scale);
    CHECK(other.upper - other.lower <= 4.0 * (upper - lower));  // not much of the room is wasted
  }
}

TEST_CASE("names stand at 0, 1, 2 with half a step beside them") {
  const Ticks ticks = make_name_ticks({"base", "elbow"});
  CHECK(ticks.labels == Labels{"base", "elbow"});
  CHECK(ticks.position(0.5) == doctest::Approx(0.5));
  CHECK(ticks.lower == -0.5);
}
