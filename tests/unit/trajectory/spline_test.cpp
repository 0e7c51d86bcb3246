#include "armlet/trajectory/spline.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "armlet/core/error.hpp"

using namespace armlet;

// Speeds at the points from SciPy 1.10, CubicSpline(t, q, bc_type='clamped').
TEST_CASE("a clamped spline has the speeds that SciPy computes") {
  const std::array t{0.0, 1.0, 2.5, 3.0, 4.2};
  const std::array q{0.0, 1.0, 0.5, 2.0, 1.0};
  const std::array v{0.0, 0.199389, 2.503054, 1.925393, 0.0};
  const std::vector<Segment> pieces = cubic_spline(t, q);
  REQUIRE(pieces.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(pieces[i].value(0.0, 1) == doctest::Approx(v[i]).epsilon(1e-6));
  }
}

TEST_CASE("position, speed and acceleration agree on both sides of every point") {
  std::mt19937_64 generator(5);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
  for (int k = 0; k < 100; ++k) {
    std::vector<double> t = {0.0};
    std::vector<double> q = {number()};
    const std::size_t points = 2 + generator() % 12;
    while (t.size() < points) {
      t.push_back(t.back() + 0.1 + number());
      q.push_back(2.0 * number() - 1.0);
    }
    const std::vector<Segment> pieces = cubic_spline(t, q, 0.3, -0.4);
    CHECK(pieces.front().value(0.0, 1) == 0.3);
    CHECK(pieces.back().value(pieces.back().duration, 1) == doctest::Approx(-0.4).epsilon(1e-9));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      CHECK(pieces[i].value(0.0) == q[i]);
      CHECK(pieces[i].value(pieces[i].duration) == doctest::Approx(q[i + 1]).epsilon(1e-12));
      if (i + 1 == pieces.size()) continue;
      for (int order = 1; order <= 2; ++order) {
        CHECK(pieces[i].value(pieces[i].duration, order) ==
              doctest::Approx(pieces[i + 1].value(0.0, order)).epsilon(1e-9).scale(10.0));
      }
    }
  }
}

TEST_CASE("points that make no spline are refused") {
  const std::array one{0.0};
  const std::array late{0.1, 0.2};
  const std::array equal{0.0, 0.0};
  const std::array q{1.0, 2.0};
  CHECK_THROWS_AS((void)cubic_spline(one, one), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(one, q), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(late, q), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(equal, q), ArgumentError);
}
