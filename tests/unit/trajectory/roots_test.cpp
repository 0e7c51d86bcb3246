#include "trajectory/roots.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace armlet;

namespace {

std::vector<double> roots_of(const Segment& piece, int order) {
  const Roots roots = sign_changes(piece, order);
  return {roots.begin(), roots.end()};
}

}  // namespace

// (u - 0.1)(u - 0.25)(u - 0.5)(u - 0.9), expanded by hand.
TEST_CASE("all roots of a quartic are found, in order") {
  const Segment quartic{.duration = 1.0, .degree = 4, .c = {0.01125, -0.1925, 0.965, -1.75, 1.0}};
  const auto roots = roots_of(quartic, 0);
  REQUIRE(roots.size() == 4);
  CHECK(roots[0] == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(roots[1] == doctest::Approx(0.25).epsilon(1e-12));
  CHECK(roots[2] == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(roots[3] == doctest::Approx(0.9).epsilon(1e-12));
}

TEST_CASE("roots of random polynomials are where they were put") {
  std::mt19937_64 generator(7);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
  for (int k = 0; k < 1000; ++k) {
    // A cubic with roots a < b < c in [0, 1], at least 0.05 apart.
    const double a = 0.2 * number();
    const double b = a + 0.05 + 0.3 * number();
    const double c = b + 0.05 + 0.3 * number();
    const Segment cubic{
        .duration = 1.0, .degree = 3, .c = {-a * b * c, a * b + a * c + b * c, -a - b - c, 1.0}};
    const auto roots = roots_of(cubic, 0);
    REQUIRE(roots.size() == 3);
    // Rounding of the coefficients moves a root by about 1e-16 over the gaps squared.
    CHECK(std::abs(roots[0] - a) < 1e-12);
    CHECK(std::abs(roots[1] - b) < 1e-12);
    CHECK(std::abs(roots[2] - c) < 1e-12);
  }
}

TEST_CASE("constants, lines without a root and touching parabolas have no sign change") {
  CHECK(roots_of({.duration = 1.0, .degree = 0, .c = {2.0}}, 0).empty());
  CHECK(roots_of({.duration = 1.0, .degree = 1, .c = {2.0, 1.0}}, 0).empty());
  CHECK(roots_of({.duration = 1.0, .degree = 2, .c = {0.26, -1.0, 1.0}}, 0).empty());
  CHECK(roots_of({.duration = 1.0, .degree = 2, .c = {0.0, 0.0, 1.0}}, 3).empty());
}
