#include "armlet/math/find_root.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"

using namespace armlet;
using Status = RootSearch::Status;

namespace {

template <class F>
RootSearch search(F f, double lo, double hi) {
  return find_root(
      [&](double x, double& value) {
        value = f(x);
        return true;
      },
      lo, hi);
}

}  // namespace

// x^3 - 2x - 5: J. Wallis, 1685 (OEIS A007493); cos x = x: OEIS A003957; x e^x = 1: OEIS A030178.
TEST_CASE("roots known to many digits are found to the last bits") {
  const RootSearch wallis = search([](double x) { return x * x * x - 2.0 * x - 5.0; }, 2.0, 3.0);
  CHECK(wallis.status == Status::kFound);
  CHECK(std::abs(wallis.x - 2.09455148154232659148) < 2e-15);
  CHECK(std::abs(search([](double x) { return std::cos(x) - x; }, 0.0, 1.0).x -
                 0.73908513321516064165) < 5e-16);
  CHECK(std::abs(search([](double x) { return x * std::exp(x) - 1.0; }, 0.0, 1.0).x -
                 0.56714329040978387300) < 5e-16);
}

TEST_CASE("Kepler's equation is solved for any eccentricity") {
  Random random(5);
  for (int k = 0; k < 2000; ++k) {
    const double e = random.uniform(0.0, 0.999);
    const double anomaly = random.uniform(0.0, 6.28);
    const auto f = [&](double x) {
      return x - e * std::sin(x) - (anomaly - e * std::sin(anomaly));
    };
    const RootSearch found = search(f, -1.0, 8.0);
    REQUIRE(found.status == Status::kFound);
    // Where the slope 1 - e cos x is small, rounding of f moves the root.
    const double slope = 1.0 - e * std::cos(anomaly);
    CHECK(std::abs(found.x - anomaly) < 1e-14 / std::max(slope, 1e-3));
    CHECK(found.evaluations < 60);
  }
}

TEST_CASE("flat and steep functions need no more than a few times the steps of halving") {
  for (const int power : {3, 9, 19, 25}) {
    const RootSearch found = search([&](double x) { return std::pow(x - 0.3, power); }, -1.0, 4.0);
    CHECK(found.status == Status::kFound);
    CHECK(found.evaluations < 200);
    CHECK(std::abs(found.value) < 1e-30);
  }
  const RootSearch steep = search([](double x) { return std::atan(1e9 * (x - 1e-6)); }, -1.0, 1.0);
  CHECK(steep.status == Status::kFound);
  CHECK(std::abs(steep.x - 1e-6) < 1e-20);
}

TEST_CASE("the ends may be exchanged, and may be roots themselves") {
  const auto f = [](double x) { return x * x - 2.0; };
  CHECK(search(f, 2.0, 0.0).x == doctest::Approx(std::sqrt(2.0)).epsilon(1e-15));
  const RootSearch at_lo = search([](double x) { return x; }, 0.0, 1.0);
  CHECK(at_lo.status == Status::kFound);
  CHECK(at_lo.x == 0.0);
  CHECK(search([](double x) { return x - 1.0; }, 0.0, 1.0).x == 1.0);
  CHECK(search([](double x) { return x; }, 0.0, 0.0).status == Status::kFound);
}

TEST_CASE("ends of one sign are reported with both values") {
  const RootSearch found = search([](double x) { return x * x + 1.0; }, -1.0, 2.0);
  CHECK(found.status == Status::kSameSign);
  CHECK(found.at_lo == 2.0);
  CHECK(found.at_hi == 5.0);
}

TEST_CASE("a jump and a pole are not taken for roots") {
  const RootSearch jump = search([](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0.0, 1.0);
  CHECK(jump.status == Status::kJump);
  CHECK(jump.x == doctest::Approx(0.7));
  CHECK(search([](double x) { return std::tan(x); }, 1.0, 2.0).status == Status::kJump);
}

TEST_CASE("trouble in the function is reported with its argument") {
  const RootSearch undefined = search([](double x) { return std::log(x); }, -1.0, 2.0);
  CHECK(undefined.status == Status::kNotFinite);
  CHECK(undefined.x == -1.0);
  CHECK(find_root([](double, double&) { return false; }, 0.0, 1.0).status == Status::kStopped);
  CHECK_THROWS_AS(search([](double x) { return x; }, NAN, 1.0), ArgumentError);
}
