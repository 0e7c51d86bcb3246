#include "armlet/cell/clock.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "armlet/core/error.hpp"

using namespace armlet;

TEST_CASE("a thousand milliseconds are one second, exactly") {
  Clock clock;
  for (int k = 0; k < 1000; ++k) clock.advance_to(clock.now_ns() + to_ns(0.001));
  CHECK(clock.now_ns() == kNanosecondsPerSecond);
  CHECK(to_seconds(clock.now_ns()) == 1.0);
}

TEST_CASE("seconds become the nearest nanosecond, and other numbers are refused") {
  CHECK(to_ns(0.1) == 100000000);
  CHECK(to_ns(1e-9 * 0.6) == 1);
  CHECK(to_ns(0.0) == 0);
  CHECK_THROWS_AS((void)to_ns(-1e-9), ArgumentError);
  CHECK_THROWS_AS((void)to_ns(std::nan("")), ArgumentError);
  CHECK_THROWS_AS((void)to_ns(1e12), ArgumentError);
}

TEST_CASE("time never goes back") {
  Clock clock;
  clock.advance_to(5);
  clock.advance_to(5);
  CHECK_THROWS_AS(clock.advance_to(4), ArgumentError);
  CHECK(clock.now_ns() == 5);
}

TEST_CASE("the pacer is called before every step") {
  Clock clock;
  std::vector<std::int64_t> heard;
  clock.set_pacer([&](std::int64_t t_ns) {
    CHECK(clock.now_ns() < t_ns);
    heard.push_back(t_ns);
  });
  clock.advance_to(0);
  clock.advance_to(3);
  clock.advance_to(3);
  clock.advance_to(8);
  CHECK(heard == std::vector<std::int64_t>{3, 8});
}
