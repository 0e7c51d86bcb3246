#include "armlet/trajectory/profile.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "uniform.hpp"

using namespace armlet;

namespace {

Trajectory one_joint(std::vector<Segment> pieces, double end) {
  const double T = pieces.back().end();
  return {{{std::move(pieces), end}}, T};
}

}  // namespace

// Peaks of the two-point laws from rest to rest: Biagiotti and Melchiorri, Trajectory Planning for
// Automatic Machines and Robots (2008), table 2.1 (cubic 1.5 and 6, quintic 15/8 and 10/sqrt(3),
// 60).
TEST_CASE("cubic and quintic have their published peaks") {
  const Trajectory cubic = one_joint({cubic_segment({.q = 0.0}, {.q = 1.0}, 1.0)}, 1.0);
  CHECK(cubic.peak(0, 1) == doctest::Approx(1.5).epsilon(1e-14));
  CHECK(cubic.peak(0, 2) == doctest::Approx(6.0).epsilon(1e-14));
  const Trajectory quintic = one_joint({quintic_segment({.q = 0.0}, {.q = 1.0}, 1.0)}, 1.0);
  CHECK(quintic.peak(0, 1) == doctest::Approx(1.875).epsilon(1e-14));
  CHECK(quintic.peak(0, 2) == doctest::Approx(5.773502691896258).epsilon(1e-13));
  CHECK(quintic.peak(0, 3) == doctest::Approx(60.0).epsilon(1e-14));
}

// The same table: septic 35/16, 7.5132 and 52.5; cycloid 2, 2 pi and 4 pi^2.
TEST_CASE("septic and cycloid have their published peaks") {
  const Trajectory septic = one_joint({septic_segment(0.0, 1.0, 1.0)}, 1.0);
  CHECK(septic.peak(0, 1) == doctest::Approx(2.1875).epsilon(1e-13));
  CHECK(septic.peak(0, 2) == doctest::Approx(7.5131884).epsilon(1e-7));
  CHECK(septic.peak(0, 3) == doctest::Approx(52.5).epsilon(1e-12));
  CHECK(septic.continuity(0) == 3);
  const Trajectory cycloid = one_joint(cycloid_segments(0.0, 1.0, 1.0), 1.0);
  CHECK(cycloid.peak(0, 1) == doctest::Approx(2.0).epsilon(1e-12));
  CHECK(cycloid.peak(0, 2) == doctest::Approx(6.283185307179586).epsilon(1e-10));
  CHECK(cycloid.peak(0, 3) == doctest::Approx(39.47841760435743).epsilon(1e-8));
  CHECK(cycloid.continuity(0, 1e-8) == 2);
  for (double x = 0.0; x <= 1.0; x += 0.0037) {
    const double exact = x - std::sin(2.0 * 3.14159265358979323846 * x) / 6.283185307179586;
    CHECK(std::abs(cycloid.value(0, x) - exact) < 1e-13);
  }
}

TEST_CASE("least times give exactly the limit that decides") {
  const AxisLimits limits{.speed = 1.1, .acceleration = 2.3, .jerk = 17.0};
  for (const double D : {0.01, 0.3, 5.0}) {
    const LeastTime septic = septic_least_time(D, limits);
    const LeastTime cycloid = cycloid_least_time(D, limits);
    const Trajectory a = one_joint({septic_segment(0.0, D, septic.time)}, D);
    const Trajectory b = one_joint(cycloid_segments(0.0, D, cycloid.time), D);
    for (const Trajectory& law : {a, b}) {
      const double load =
          std::max({law.peak(0, 1) / limits.speed, law.peak(0, 2) / limits.acceleration,
                    law.peak(0, 3) / limits.jerk});
      CHECK(load == doctest::Approx(1.0).epsilon(1e-8));
    }
  }
}

TEST_CASE("a quartic starts with its acceleration, and reversed ends with it") {
  const AxisState from{0.3, -0.4, 1.5}, to{1.2, 0.6, 0.0};
  const Segment quartic = quartic_segment(from, to, 1.7);
  CHECK(quartic.value(0.0, 2) == doctest::Approx(1.5));
  CHECK(quartic.value(1.7) == doctest::Approx(1.2).epsilon(1e-13));
  CHECK(quartic.value(1.7, 1) == doctest::Approx(0.6).epsilon(1e-13));
  const Segment back = reversed(quartic, 2.0);
  CHECK(back.start == 2.0);
  CHECK(back.value(1.7, 2) == doctest::Approx(1.5).epsilon(1e-12));
  CHECK(back.value(0.5) == doctest::Approx(quartic.value(1.2)).epsilon(1e-13));
  CHECK(back.value(0.5, 1) == doctest::Approx(-quartic.value(1.2, 1)).epsilon(1e-12));
}

TEST_CASE("polynomials meet every condition at both ends") {
  std::mt19937_64 generator(1);
  const auto number = [&] { return uniform(generator, -2.0, 2.0); };
  for (int k = 0; k < 500; ++k) {
    const AxisState from{number(), number(), number()};
    const AxisState to{number(), number(), number()};
    const double T = uniform(generator, 0.2, 3.0);
    const Segment quintic = quintic_segment(from, to, T);
    const Segment cubic = cubic_segment(from, to, T);
    // The coefficients grow as 1/T^5, so rounding is relative to about 100.
    const auto near = [](double x) { return doctest::Approx(x).epsilon(1e-12).scale(100.0); };
    CHECK(quintic.value(0.0) == near(from.q));
    CHECK(quintic.value(0.0, 1) == near(from.v));
    CHECK(quintic.value(0.0, 2) == near(from.a));
    CHECK(quintic.value(T) == near(to.q));
    CHECK(quintic.value(T, 1) == near(to.v));
    CHECK(quintic.value(T, 2) == near(to.a));
    CHECK(cubic.value(0.0) == near(from.q));
    CHECK(cubic.value(0.0, 1) == near(from.v));
    CHECK(cubic.value(T) == near(to.q));
    CHECK(cubic.value(T, 1) == near(to.v));
  }
}

TEST_CASE("at the least time one limit is reached and none exceeded") {
  std::mt19937_64 generator(2);
  for (int k = 0; k < 500; ++k) {
    const double D = uniform(generator, -3.0, 3.0);
    const AxisLimits limits{.speed = uniform(generator, 0.1, 3.0),
                            .acceleration = uniform(generator, 0.1, 9.0),
                            .jerk = uniform(generator, 1.0, 90.0)};
    const auto load = [&](const Trajectory& motion, bool with_jerk) {
      const double a = motion.peak(0, 2) / limits.acceleration;
      const double j = with_jerk ? motion.peak(0, 3) / limits.jerk : 0.0;
      return std::max({motion.peak(0, 1) / limits.speed, a, j});
    };
    const double T5 = quintic_least_time(D, limits).time;
    CHECK(load(one_joint({quintic_segment({}, {.q = D}, T5)}, D), true) ==
          doctest::Approx(1.0).epsilon(1e-12));
    const double T3 = cubic_least_time(D, limits).time;
    CHECK(load(one_joint({cubic_segment({}, {.q = D}, T3)}, D), false) ==
          doctest::Approx(1.0).epsilon(1e-12));
    const Trapezoid shape = fastest_trapezoid(D, limits);
    CHECK(load(one_joint(trapezoid_segments(0.0, D, shape), D), false) ==
          doctest::Approx(1.0).epsilon(1e-12));
  }
}

// A straight line of length 2 with V = 1, A = 2 takes 2.5 s; short travel makes a triangle.
TEST_CASE("trapezoids have the textbook durations") {
  const AxisLimits limits{.speed = 1.0, .acceleration = 2.0};
  CHECK(fastest_trapezoid(2.0, limits).duration == doctest::Approx(2.5).epsilon(1e-15));
  CHECK(trapezoid_least_time(2.0, limits).limit == LimitKind::kSpeed);
  CHECK(fastest_trapezoid(0.02, limits).duration == doctest::Approx(0.2).epsilon(1e-15));
  CHECK(trapezoid_least_time(0.02, limits).limit == LimitKind::kAcceleration);
  CHECK(fastest_trapezoid(0.0, limits).duration == 0.0);
}

TEST_CASE("a trapezoid for a given time has exactly that time, acceleration and travel") {
  std::mt19937_64 generator(3);
  for (int k = 0; k < 500; ++k) {
    const double D = uniform(generator, 0.01, 3.0);
    const double A = uniform(generator, 0.5, 9.0);
    const double T = 2.0 * std::sqrt(D / A) * uniform(generator, 1.0, 4.0);
    const auto shape = trapezoid_in_time(D, T, A);
    REQUIRE(shape.has_value());
    const Trajectory motion = one_joint(trapezoid_segments(0.5, D, *shape), 0.5 + D);
    CHECK(motion.duration() == doctest::Approx(T).epsilon(1e-12));
    CHECK(motion.peak(0, 2) == doctest::Approx(A).epsilon(1e-9));
    CHECK(motion.value(0, T * (1.0 - 1e-12)) == doctest::Approx(0.5 + D).epsilon(1e-9));
  }
  CHECK_FALSE(trapezoid_in_time(1.0, 1.0, 3.9).has_value());
}

TEST_CASE("a law without duration is refused") {
  CHECK_THROWS_AS((void)cubic_segment({}, {.q = 1.0}, 0.0), ArgumentError);
  CHECK_THROWS_AS((void)quintic_segment({}, {.q = 1.0}, -1.0), ArgumentError);
  CHECK_THROWS_AS((void)trapezoid_in_time(1.0, std::nan(""), 1.0), ArgumentError);
}
