#include "trajectory/timing/smooth_run.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/jerk_limited.hpp"
#include "paths.hpp"

using namespace armlet;

namespace {

std::vector<AxisLimits> random_limits(std::mt19937_64& generator, int n) {
  std::vector<AxisLimits> limits;
  for (int i = 0; i < n; ++i) {
    limits.push_back({uniform(generator, 0.5, 3.0), uniform(generator, 1.0, 20.0),
                      uniform(generator, 10.0, 300.0)});
  }
  return limits;
}

TimedRun run(const Trajectory& path, const std::vector<AxisLimits>& limits, int cells) {
  return smooth_run(path, limits, fastest_along(path, limits, 200), cells);
}

}  // namespace

// The motion of seven phases is the fastest there is (Kroeger, On-Line Trajectory Generation,
// 2010).
TEST_CASE("a straight line is run nearly as fast as the seven phases do") {
  std::mt19937_64 generator(1);
  double worst = 0.0;
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    const std::vector<AxisLimits> l{{uniform(generator, 0.2, 3.0), uniform(generator, 0.5, 9.0),
                                     uniform(generator, 5.0, 200.0)}};
    const double L = uniform(generator, 0.1, 5.0);
    const double least = fastest_jerk_limited({.q = 0.0}, L, l[0]).duration();
    const double T = run(straight_line(L), l, 64).motion.duration();
    CHECK(T >= least * (1.0 - 1e-9));
    CHECK(T <= least * 1.01);
    worst = std::max(worst, T / least);
  }
  MESSAGE("at most " << 100.0 * (worst - 1.0) << " % more");
}

TEST_CASE("limits hold everywhere, accelerations are continuous, the path is kept") {
  std::mt19937_64 generator(2);
  double worst = 0.0;
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    const int n = 1 + static_cast<int>(generator() % 7);
    const Trajectory path = random_path(generator, n, 6);
    const std::vector<AxisLimits> limits = random_limits(generator, n);
    const TimedRun made = run(path, limits, 96);
    const Trajectory& motion = made.motion;
    for (int i = 0; i < n; ++i) {
      const AxisLimits& l = limits[static_cast<std::size_t>(i)];
      CHECK(motion.continuity(i, 1e-7) >= 2);
      CHECK(motion.peak(i, 1) <= l.speed * (1.0 + 1e-9));
      CHECK(motion.peak(i, 2) <= l.acceleration * (1.0 + 1e-9));
      CHECK(motion.peak(i, 3) <= l.jerk * (1.0 + 1e-9));
      for (std::size_t j = 0; j < made.s.size(); j += 7)
        CHECK(std::abs(motion.value(i, made.t[j]) - path.value(i, made.s[j])) < 1e-9);
    }
    CHECK((motion.end() - path.end()).norm() == 0.0);
    // Many more pieces make it hardly faster: 1.4 % were measured.
    const double T = run(path, limits, 600).motion.duration();
    CHECK(motion.duration() <= T * 1.02);
    CHECK(motion.duration() >= fastest_along(path, limits, 400).duration() * (1.0 - 1e-3));
    worst = std::max(worst, motion.duration() / T);
  }
  MESSAGE("at most " << 100.0 * (worst - 1.0) << " % more");
}

TEST_CASE("without a limit that counts the run is that of speeds and accelerations") {
  std::mt19937_64 generator(3);
  for (int k = 0; k < 10; ++k) {
    const Trajectory path = random_path(generator, 3, 6);
    std::vector<AxisLimits> limits = random_limits(generator, 3);
    for (AxisLimits& l : limits) l.jerk = 1e6;
    const double least = time_optimal(path, limits, 1000).duration();
    // Accelerations take a piece to change, of which there are 400.
    CHECK(run(path, limits, 400).motion.duration() <= least * 1.05);
  }
}

// The search ends within 2e-3 of the least; where in there, rounding decides.
TEST_CASE("the same path and limits in other units of time and length take the same") {
  const Trajectory path = straight_line(2.0);
  const std::vector<AxisLimits> limits{{1.0, 2.0, 10.0}};
  const double T = run(path, limits, 64).motion.duration();
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    const std::vector<AxisLimits> scaled{{scale, 2.0 * scale, 10.0 * scale}};
    CHECK(run(straight_line(2.0 * scale), scaled, 64).motion.duration() ==
          doctest::Approx(T).epsilon(2e-4));
    const std::vector<AxisLimits> slower{
        {1.0 / scale, 2.0 / (scale * scale), 10.0 / (scale * scale * scale)}};
    CHECK(run(path, slower, 64).motion.duration() == doctest::Approx(T * scale).epsilon(2e-4));
  }
}

TEST_CASE("zones limit what travels, and positions are passed at the given times") {
  const Trajectory path = straight_line(2.0);
  const std::vector<AxisLimits> limits{{1.0, 2.0, 20.0}};
  const std::vector<SpeedZone> zones{{.from = 0.8, .to = 1.2, .speed = 0.3}};
  // What travels becomes faster than the path in the second half, at 1.2 by half.
  const std::vector<Segment> travel{
      {.start = 0.0, .duration = 1.0, .degree = 1, .c = {0.0, 1.0}},
      {.start = 1.0, .duration = 1.0, .degree = 2, .c = {1.0, 1.0, 1.25}}};
  const TimedRun made =
      smooth_run(path, limits, fastest_along(path, limits, 200, zones, travel), 96, zones, travel);
  for (int k = 0; k <= 2000; ++k) {
    const double t = made.motion.duration() * k / 2000.0;
    const double s = made.motion.value(0, t), v = made.motion.value(0, t, 1);
    const double rate = s < 1.0 ? 1.0 : 1.0 + 2.5 * (s - 1.0);
    if (s > 0.8 && s < 1.2) CHECK(v * rate <= 0.3 * (1.0 + 2e-3));
  }
  for (const double place : {0.0, 0.3, 0.8, 1.0, 1.7, 2.0})
    CHECK(made.motion.value(0, made.time_at(place)) == doctest::Approx(place).epsilon(1e-3));
}

// A straight line in two pieces with speeds of their own. The least time is not known in closed
// form, but the time without limits on jerk is a lower bound, and both ends and the border cannot
// need more than the jerk-limited changes of speed one after another.
TEST_CASE("pieces of very different speeds take hardly more than their speeds ask for") {
  std::mt19937_64 generator(4);
  double worst = 0.0;
  for (int k = 0; k < 150; ++k) {
    CAPTURE(k);
    const double L = uniform(generator, 0.1, 2.0), border = uniform(generator, 0.2, 0.8) * L;
    const double slow = 0.001 * std::pow(10.0, uniform(generator, 0.0, 2.0));
    const double fast = std::min(1.0, slow * std::pow(10.0, uniform(generator, 0.0, 2.0)));
    const bool up = generator() % 2 == 0;
    const double first = up ? slow : fast, second = up ? fast : slow;
    CAPTURE(first);
    CAPTURE(second);
    const std::vector<AxisLimits> limits{
        {1.0, uniform(generator, 1.0, 20.0), uniform(generator, 20.0, 300.0)}};
    const std::vector<SpeedZone> zones{{.from = 0.0, .to = border, .speed = first},
                                       {.from = border, .to = L, .speed = second}};
    const Trajectory path = straight_line(L);
    const TimedRun made =
        smooth_run(path, limits, fastest_along(path, limits, 200, zones), 96, zones);
    CHECK(made.is_fastest);
    const auto change = [&](double from, double to) {  // s, with limited jerk and acceleration
      const double dv = std::abs(to - from), A = limits[0].acceleration, J = limits[0].jerk;
      return dv * J >= A * A ? A / J + dv / A : 2.0 * std::sqrt(dv / J);
    };
    const double least = border / first + (L - border) / second;
    const double most = least + change(0.0, first) + change(first, second) + change(second, 0.0);
    const double T = made.motion.duration();
    CHECK(T >= least * (1.0 - 1e-3));
    CHECK(T <= 1.03 * most);
    worst = std::max(worst, T / most);
  }
  MESSAGE("at most " << 100.0 * (worst - 1.0) << " % more");
}

TEST_CASE("a run without limits on jerk is refused") {
  const Trajectory path = straight_line(1.0);
  const std::vector<AxisLimits> limits{{1.0, 1.0}};
  CHECK_THROWS_AS((void)smooth_run(path, limits, fastest_along(path, limits, 100), 64),
                  ArgumentError);
}
