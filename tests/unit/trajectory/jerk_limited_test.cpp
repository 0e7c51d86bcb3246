#include "armlet/trajectory/jerk_limited.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "uniform.hpp"

using namespace armlet;

namespace {

// Speeds and travels of all sizes, so that every case of the law occurs.
struct RandomMove {
  AxisState from{};
  double to = 0.0;
  AxisLimits limits{};
};

RandomMove random_move(std::mt19937_64& generator, bool moving) {
  const auto size = [&] { return std::pow(10.0, uniform(generator, -1.0, 1.0)); };
  RandomMove move;
  move.limits = {.speed = size(), .acceleration = 2.0 * size(), .jerk = 10.0 * size()};
  move.from.q = uniform(generator, -3.0, 3.0);
  move.to = move.from.q + uniform(generator, -1.0, 1.0) * size();
  if (!moving) return move;
  move.from.v = uniform(generator, -1.0, 1.0) * move.limits.speed;
  if (generator() % 3 == 0) return move;
  // An acceleration from which the speed limit can still be kept.
  const double room = move.limits.speed - std::abs(move.from.v);
  const double most = std::min(move.limits.acceleration, std::sqrt(2.0 * move.limits.jerk * room));
  move.from.a = uniform(generator, -1.0, 1.0) * most;
  return move;
}

struct Extremes {
  double speed = 0.0, acceleration = 0.0, jerk = 0.0;
  AxisState end{};
};

// Integrates the jerks step by step. Speed is largest where acceleration passes zero.
Extremes run(const AxisState& from, const JerkProfile& profile) {
  Extremes most{.speed = std::abs(from.v), .acceleration = std::abs(from.a), .end = from};
  for (const auto& [T, j] : profile.steps()) {
    AxisState& s = most.end;
    const double turn = j != 0.0 ? -s.a / j : -1.0;
    if (turn > 0.0 && turn < T) {
      most.speed = std::max(most.speed, std::abs(s.v + 0.5 * s.a * turn));
    }
    s.q += T * (s.v + T * (0.5 * s.a + T * j / 6.0));
    s.v += T * (s.a + 0.5 * T * j);
    s.a += T * j;
    most.speed = std::max(most.speed, std::abs(s.v));
    most.acceleration = std::max(most.acceleration, std::abs(s.a));
    most.jerk = std::max(most.jerk, std::abs(j));
  }
  return most;
}

void check_move(const RandomMove& move, const JerkProfile& profile) {
  const Extremes most = run(move.from, profile);
  CHECK(std::abs(most.end.q - move.to) < 1e-9);
  CHECK(std::abs(most.end.v) < 1e-9);
  CHECK(std::abs(most.end.a) < 1e-9);
  CHECK(most.speed <= move.limits.speed + 1e-9);
  CHECK(most.acceleration <= move.limits.acceleration + 1e-9);
  CHECK(most.jerk <= move.limits.jerk);
}

}  // namespace

// Durations computed with Ruckig 0.9 (Berscheid and Kroeger, RSS 2021).
TEST_CASE("durations are those of Ruckig") {
  const AxisLimits limits{.speed = 1.0, .acceleration = 2.0, .jerk = 8.0};
  const struct {
    double D, v, a, T;
  } cases[] = {{1.0, 0.0, 0.0, 1.75},        {0.01, 0.0, 0.0, 0.341995189},
               {0.3, 0.0, 0.0, 1.063941030}, {1.0, 0.5, -1.0, 1.592122396},
               {0.1, 0.9, 0.5, 1.560497860}, {-0.5, 0.8, 1.0, 2.205247396},
               {0.2, 0.8, 0.0, 1.047189382}};
  for (const auto& [D, v, a, T] : cases) {
    const auto& shown = D;  // clang 14 captures no binding
    CAPTURE(shown);
    const JerkProfile profile = fastest_jerk_limited({.q = 0.3, .v = v, .a = a}, 0.3 + D, limits);
    CHECK(profile.duration() == doctest::Approx(T).epsilon(2e-9));
  }
}

TEST_CASE("random moves end at rest on the target and break no limit") {
  for (const bool moving : {false, true}) {
    CAPTURE(moving);
    std::mt19937_64 generator(7);
    for (int k = 0; k < 100000; ++k) {
      CAPTURE(k);
      const RandomMove move = random_move(generator, moving);
      check_move(move, fastest_jerk_limited(move.from, move.to, move.limits));
    }
  }
}

TEST_CASE("a start that hardly moves needs as long as one at rest") {
  std::mt19937_64 generator(8);
  for (int k = 0; k < 5000; ++k) {
    RandomMove move = random_move(generator, false);
    const double closed = fastest_jerk_limited(move.from, move.to, move.limits).duration();
    move.from.v = 1e-14;  // takes the general branch
    const double general = fastest_jerk_limited(move.from, move.to, move.limits).duration();
    CHECK(general == doctest::Approx(closed).epsilon(1e-7));
  }
}

TEST_CASE("no part of a fastest motion can be made faster") {
  std::mt19937_64 generator(9);
  for (int k = 0; k < 3000; ++k) {
    CAPTURE(k);
    const RandomMove move = random_move(generator, true);
    const JerkProfile whole = fastest_jerk_limited(move.from, move.to, move.limits);
    const Trajectory motion = jerk_trajectory(std::span(&move.from, 1), std::span(&move.to, 1),
                                              std::span(&whole, 1), whole.duration());
    const double t = uniform(generator, 0.0, 0.9) * whole.duration();
    const AxisState there{motion.value(0, t), motion.value(0, t, 1), motion.value(0, t, 2)};
    const JerkProfile rest = fastest_jerk_limited(there, move.to, move.limits);
    // A position that is off by rounding, 1e-16, is worth the cube root of it in time.
    CHECK(t + rest.duration() == doctest::Approx(whole.duration()).epsilon(1e-4));
  }
}

TEST_CASE("a start beyond the limits comes back within them and reaches its target") {
  std::mt19937_64 generator(10);
  for (int k = 0; k < 5000; ++k) {
    CAPTURE(k);
    RandomMove move = random_move(generator, true);
    move.from.v *= 3.0;
    move.from.a = uniform(generator, -1.5, 1.5) * move.limits.acceleration;
    const JerkProfile profile = fastest_jerk_limited(move.from, move.to, move.limits);
    const Extremes most = run(move.from, profile);
    // Coming back can take many minutes, over which rounding of the speed adds up.
    CHECK(std::abs(most.end.q - move.to) < 1e-9 * std::max(1.0, profile.duration()));
    CHECK(std::abs(most.end.v) < 1e-9);
    CHECK(most.acceleration <= std::max(std::abs(move.from.a), move.limits.acceleration) + 1e-9);
  }
}

TEST_CASE("slowed down to a given time a move takes exactly that and keeps its limits") {
  for (const bool moving : {false, true}) {
    CAPTURE(moving);
    std::mt19937_64 generator(11);
    int slowed = 0;
    const int tries = 5000;
    for (int k = 0; k < tries; ++k) {
      CAPTURE(k);
      const RandomMove move = random_move(generator, moving);
      const JerkProfile fastest = fastest_jerk_limited(move.from, move.to, move.limits);
      const double T = fastest.duration() * uniform(generator, 1.0, 4.0);
      const auto slower = jerk_limited_in_time(move.from, move.to, move.limits, T, fastest);
      if (!slower) continue;
      ++slowed;
      CHECK(slower->duration() == doctest::Approx(T).epsilon(1e-11));
      check_move(move, *slower);
    }
    CHECK(slowed >= (moving ? 0.95 : 1.0) * tries);
  }
  const AxisLimits limits{.speed = 1.0, .acceleration = 1.0, .jerk = 1.0};
  const JerkProfile fastest = fastest_jerk_limited({}, 1.0, limits);
  CHECK_FALSE(jerk_limited_in_time({}, 1.0, limits, 0.9 * fastest.duration(), fastest));
}

TEST_CASE("several joints from rest end together, in cubic pieces with continuous acceleration") {
  std::mt19937_64 generator(12);
  for (int k = 0; k < 200; ++k) {
    std::array<AxisState, 7> from;
    std::array<double, 7> to{};
    std::array<AxisLimits, 7> limits;
    std::array<JerkProfile, 7> profiles;
    for (std::size_t i = 0; i < 7; ++i) {
      const RandomMove move = random_move(generator, false);
      from[i] = move.from;
      to[i] = move.to;
      limits[i] = move.limits;
    }
    const double T = plan_jerk_limited(from, to, limits, profiles);
    const Trajectory motion = jerk_trajectory(from, to, profiles, T);
    for (int i = 0; i < 7; ++i) {
      CHECK(std::abs(motion.joint(i).segments.back().end() - T) < 1e-12 * std::max(T, 1.0));
      CHECK(motion.continuity(i, 1e-8) == 2);
      CHECK(motion.peak(i, 3) <= limits[static_cast<std::size_t>(i)].jerk * (1.0 + 1e-12));
    }
  }
}

TEST_CASE("limits that are missing and states that are not finite are refused") {
  std::array<JerkProfile, 1> profiles;
  const auto plan = [&](AxisState from, double to, AxisLimits limits) {
    (void)plan_jerk_limited(std::span(&from, 1), std::span(&to, 1), std::span(&limits, 1),
                            profiles);
  };
  const AxisLimits good{1.0, 1.0, 1.0};
  CHECK_THROWS_AS(plan({}, std::nan(""), good), ArgumentError);
  CHECK_THROWS_AS(plan({.v = INFINITY}, 1.0, good), ArgumentError);
  CHECK_THROWS_AS(plan({}, 1.0, {.speed = 1.0, .acceleration = 1.0}), ArgumentError);
  CHECK_THROWS_AS(plan({}, 1.0, {0.0, 1.0, 1.0}), ArgumentError);
  CHECK_THROWS_AS((void)plan_jerk_limited({}, {}, std::span(&good, 1), profiles), ArgumentError);
}

TEST_CASE("no travel has no steps") {
  const JerkProfile still = fastest_jerk_limited({.q = 0.4}, 0.4, {1.0, 1.0, 1.0});
  CHECK(still.steps().empty());
  CHECK(still.duration() == 0.0);
}
