#include "armlet/core/error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace armlet;

namespace {

std::string message_of(auto action) {
  try {
    action();
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace

TEST_CASE("a wrong size is reported with both sizes") {
  CHECK(message_of([] { check_size("q", 5, 6); }) == "`q` has 5 elements; expected 6.");
  CHECK(message_of([] { check_size("q", 1, 2); }) == "`q` has 1 element; expected 2.");
  CHECK_NOTHROW(check_size("q", 6, 6));
}

TEST_CASE("a value that is not finite is reported") {
  CHECK_NOTHROW(check_finite("t", 1e300));
  CHECK(message_of([] { check_finite("t", -INFINITY); }) ==
        "`t` is -inf; it must be a finite number.");
}

TEST_CASE("zero is not positive") {
  CHECK(message_of([] { check_positive("T", 0.0); }) == "`T` is 0; it must be greater than zero.");
  CHECK_NOTHROW(check_positive("T", 1e-300));
}

TEST_CASE("a result holds a value or the reason why there is none") {
  const Result<int> good = 3;
  REQUIRE(good.ok());
  CHECK(*good == 3);
  CHECK_THROWS_AS(good.error(), ArgumentError);

  const Result<std::string> bad = Error{"unreachable", "The point is out of reach."};
  CHECK_FALSE(bad);
  CHECK(bad.error().code == "unreachable");
  CHECK(message_of([&] { bad.value(); }) == "The point is out of reach.");
}
