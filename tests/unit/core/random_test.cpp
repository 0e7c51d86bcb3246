#include "armlet/core/random.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "armlet/core/error.hpp"

using namespace armlet;

// xoshiro256** from the state that splitmix64 makes of the seed 0. The first output follows by hand
// from the published second word of splitmix64, 0x6e789e6aa1b965f4: rotl(5 w, 7) * 9.
TEST_CASE("the sequence is that of xoshiro256** seeded by splitmix64") {
  Random random(0);
  CHECK(random.next() == 0x99ec5f36cb75f2b4u);
  CHECK(random.next() == 0xbf6e1f784956452au);
}

TEST_CASE("the same seed gives the same numbers and another seed others") {
  Random a(17), b(17), c(18);
  bool differ = false;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t x = a.next();
    CHECK(x == b.next());
    differ = differ || x != c.next();
  }
  CHECK(differ);
}

TEST_CASE("uniform numbers stay in their range and have its mean and spread") {
  Random random(1);
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 100'000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.uniform(-2.0, 4.0);
    REQUIRE(x >= -2.0);
    REQUIRE(x < 4.0);
    sum += x;
    squares += (x - 1.0) * (x - 1.0);
  }
  CHECK(sum / kCount == doctest::Approx(1.0).epsilon(0.02));      // 3 standard errors are 0.016
  CHECK(squares / kCount == doctest::Approx(3.0).epsilon(0.02));  // width squared over 12
}

TEST_CASE("whole numbers below n are equally likely") {
  Random random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70'000; ++i) ++counts[random.below(7)];
  for (const int count : counts) CHECK(std::abs(count - 10'000) < 400);  // 4 standard deviations
  CHECK(random.below(1) == 0);
}

TEST_CASE("streams split from one generator do not depend on what it drew before") {
  Random fresh(5), used(5);
  used.next();
  CHECK(fresh.split(3).next() == used.split(3).next());
  CHECK(fresh.split(3).next() != fresh.split(4).next());
}

TEST_CASE("impossible ranges are refused") {
  Random random(1);
  CHECK_THROWS_AS(random.below(0), ArgumentError);
  CHECK_THROWS_AS(random.uniform(2.0, 1.0), ArgumentError);
  CHECK_THROWS_AS(random.uniform(0.0, INFINITY), ArgumentError);
  CHECK(random.uniform(3.0, 3.0) == 3.0);
}
