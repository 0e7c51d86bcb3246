#include "armlet/trajectory/time_optimal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/spline.hpp"
#include "paths.hpp"
#include "survey.hpp"

using namespace armlet;

namespace {

// A quarter of a circle of radius 1 as a spline so fine that it is one to 1e-9.
Trajectory quarter_circle() {
  std::vector<double> s, x, y;
  for (int k = 0; k <= 60; ++k) {
    s.push_back(std::acos(-1.0) / 2.0 * k / 60.0);
    x.push_back(std::cos(s.back()));
    y.push_back(std::sin(s.back()));
  }
  // The second derivative at the ends is 0 only for y at the start and x at the end; the speeds
  // are known.
  return {{{cubic_spline(s, x, 0.0, -1.0), x.back()}, {cubic_spline(s, y, 1.0, 0.0), y.back()}},
          s.back()};
}

std::vector<AxisLimits> random_limits(std::mt19937_64& generator, int n) {
  std::vector<AxisLimits> limits;
  for (int i = 0; i < n; ++i) {
    limits.push_back({uniform(generator, 0.5, 3.0), uniform(generator, 1.0, 20.0)});
  }
  return limits;
}

// How much of its limits the motion uses at time t: the joint that uses most.
double load(const Trajectory& motion, const std::vector<AxisLimits>& limits, double t) {
  double most = 0.0;
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    most = std::max({most, std::abs(motion.value(i, t, 1)) / l.speed,
                     std::abs(motion.value(i, t, 2)) / l.acceleration});
  }
  return most;
}

// The same where the path is run at a squared speed of x and an acceleration u along it.
double load_along(const Trajectory& path, const std::vector<AxisLimits>& limits, double s, double x,
                  double u) {
  double most = 0.0;
  for (int i = 0; i < path.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    const double first = path.value(i, s, 1), second = path.value(i, s, 2);
    most = std::max({most, std::abs(first) * std::sqrt(x) / l.speed,
                     std::abs(first * u + second * x) / l.acceleration});
  }
  return most;
}

// The least duration by integration backwards and forwards over a very fine grid, with the limits
// at each of its positions alone: K. G. Shin, N. D. McKay, IEEE TAC 30(6), 1985.
class FineGrid {
 public:
  FineGrid(const Trajectory& path, const std::vector<AxisLimits>& limits, int places)
      : limits_(limits), n_(path.n()), places_(places), h_(path.duration() / places) {
    for (int k = 0; k < places; ++k) {
      for (int i = 0; i < n_; ++i) {
        first_.push_back(path.value(i, (k + 0.5) * h_, 1));
        second_.push_back(path.value(i, (k + 0.5) * h_, 2));
      }
    }
  }

  [[nodiscard]] double duration() const {
    std::vector<double> most(static_cast<std::size_t>(places_) + 1, 0.0);
    for (int k = places_ - 1; k >= 0; --k)
      most[static_cast<std::size_t>(k)] = highest(k, most[static_cast<std::size_t>(k) + 1]);
    double T = 0.0, x = 0.0;
    for (int k = 0; k < places_; ++k) {
      const double next =
          std::min(x + 2.0 * h_ * range(k, x).second, most[static_cast<std::size_t>(k) + 1]);
      T += 2.0 * h_ / (std::sqrt(x) + std::sqrt(next));
      x = next;
    }
    return T;
  }

 private:
  // Accelerations along the path that all joints allow.
  [[nodiscard]] std::pair<double, double> range(int k, double x) const {
    double lower = -1e9, upper = 1e9;
    for (int i = 0; i < n_; ++i) {
      const auto at = static_cast<std::size_t>(k * n_ + i);
      const double a = first_[at], b = second_[at] * x;
      const AxisLimits& l = limits_[static_cast<std::size_t>(i)];
      if (a * a * x > l.speed * l.speed) return {1.0, -1.0};
      if (std::abs(a) < 1e-9) {
        if (std::abs(b) > l.acceleration) return {1.0, -1.0};
        continue;
      }
      lower = std::max(lower, (-std::copysign(l.acceleration, a) - b) / a);
      upper = std::min(upper, (std::copysign(l.acceleration, a) - b) / a);
    }
    return {lower, upper};
  }

  // The highest squared speed from which `next` can be reached, by halving.
  [[nodiscard]] double highest(int k, double next) const {
    double low = 0.0, high = 1e4;
    for (int round = 0; round < 45; ++round) {
      const double x = 0.5 * (low + high);
      const auto [lower, upper] = range(k, x);
      const bool can =
          lower <= upper && x + 2.0 * h_ * lower <= next && x + 2.0 * h_ * upper >= 0.0;
      (can ? low : high) = x;
    }
    return low;
  }

  const std::vector<AxisLimits>& limits_;
  int n_, places_;
  double h_;
  std::vector<double> first_, second_;
};

}  // namespace

TEST_CASE("Fastest takes 0.5 % more than it had to at most, through any number of points") {
  std::mt19937_64 generator(survey_seed(52));
  const PlannerSet planners;
  double worst = 0.0;
  std::vector<int> counts = {2, 3, 4, 7, 7, 7, 7, 7, 7, 7, 12, 25, 60};
  for (int k = 13; k < survey_count(13); ++k)
    counts.push_back(3 + static_cast<int>(generator() % 20));
  for (const int count : counts) {
    CAPTURE(count);
    const int n = 2 + static_cast<int>(generator() % 6);
    std::vector<Eigen::VectorXd> points(static_cast<std::size_t>(count), Eigen::VectorXd(n));
    for (Eigen::VectorXd& point : points) {
      for (double& q : point) q = uniform(generator, -2.0, 2.0);
    }
    const std::vector<AxisLimits> limits = random_limits(generator, n);
    const Plan plan = planners.plan("Fastest", {.q0 = points.front(),
                                                .q1 = points.back(),
                                                .limits = limits,
                                                .via = {points.begin() + 1, points.end() - 1}});
    REQUIRE(plan.trajectory);
    const FineGrid fine(path_through(points), limits, 600 * (count - 1) + 2000);
    const double least = fine.duration();
    const double T = plan.trajectory->duration();
    CHECK(T <= least * 1.005);
    CHECK(T >= least * 0.998);
    worst = std::max(worst, T / least);
  }
  MESSAGE("at most " << 100.0 * (worst - 1.0) << " % more");
}

// Of joints in proportion, the optimum is known: from one reversal to the next a trapezoid.
TEST_CASE("points on one line are passed in the least time, with and without turning back") {
  std::mt19937_64 generator(survey_seed(53));
  const PlannerSet planners;
  for (int k = 0; k < survey_count(100); ++k) {
    CAPTURE(k);
    const std::size_t count = 2 + generator() % 24;
    const int n = 1 + static_cast<int>(generator() % 7);
    Eigen::VectorXd from(n), way(n);
    for (double& q : from) q = uniform(generator, -1.0, 1.0);
    for (double& q : way) q = uniform(generator, -1.0, 1.0);
    const std::vector<AxisLimits> limits = random_limits(generator, n);
    AxisLimits along{1e9, 1e9};
    for (int i = 0; i < n; ++i) {
      const AxisLimits& l = limits[static_cast<std::size_t>(i)];
      along.speed = std::min(along.speed, l.speed / std::abs(way[i]));
      along.acceleration = std::min(along.acceleration, l.acceleration / std::abs(way[i]));
    }
    std::vector<double> r;
    std::vector<Eigen::VectorXd> points;
    for (std::size_t i = 0; i < count; ++i) {
      r.push_back(uniform(generator, -2.0, 2.0));
      points.emplace_back(from + r.back() * way);
    }
    double least = 0.0, last = r.front();
    for (std::size_t i = 1; i < count; ++i) {
      if (i + 1 < count && (r[i] - r[i - 1]) * (r[i + 1] - r[i]) > 0.0) continue;
      least += trapezoid_least_time(std::abs(r[i] - last), along).time;
      last = r[i];
    }
    const Plan plan = planners.plan("Fastest", {.q0 = points.front(),
                                                .q1 = points.back(),
                                                .limits = limits,
                                                .via = {points.begin() + 1, points.end() - 1}});
    REQUIRE(plan.trajectory);
    CHECK(plan.trajectory->duration() <= least * 1.0005);
    CHECK(plan.trajectory->duration() >= least * (1.0 - 1e-9));
    // It goes no farther than the points.
    const double lower = from[0] + way[0] * (way[0] > 0.0 ? *std::ranges::min_element(r)
                                                          : *std::ranges::max_element(r));
    CHECK(plan.trajectory->range(0).lower >= lower - 1e-9);
    CHECK((plan.trajectory->end() - points.back()).norm() == 0.0);
  }
}

TEST_CASE("a straight line is run as the trapezoid") {
  const std::vector<AxisLimits> limits{{1.0, 2.0}};
  CHECK(fastest_along(straight_line(2.0), limits, 200).duration() ==
        doctest::Approx(2.5).epsilon(1e-9));
  // A triangle: 2 sqrt(L / A). The top lies on a position.
  CHECK(fastest_along(straight_line(0.3), limits, 200).duration() ==
        doctest::Approx(2.0 * std::sqrt(0.15)).epsilon(1e-9));
  std::mt19937_64 generator(1);
  for (int k = 0; k < 100; ++k) {
    const AxisLimits l{uniform(generator, 0.2, 3.0), uniform(generator, 0.5, 9.0)};
    const double L = uniform(generator, 0.1, 5.0);
    const double T = time_optimal(straight_line(L), std::span(&l, 1), 400).duration();
    CHECK(T == doctest::Approx(trapezoid_least_time(L, l).time).epsilon(1e-3));
    CHECK(T >= trapezoid_least_time(L, l).time * (1.0 - 1e-9));
  }
}

// Between the positions of a circle the interpolation scheme exceeds the acceleration limits by
// 1.002 (50 intervals) and less.
TEST_CASE("a circle keeps its limits between the positions, the better the more there are") {
  const std::vector<AxisLimits> limits{{10.0, 1.0}, {10.0, 1.0}};
  const Trajectory path = quarter_circle();
  double before = 1e9;
  for (const auto& [intervals, allowed] : {std::pair{60, 1.003}, {120, 1.001}, {240, 1.0003}}) {
    const Trajectory motion = run_along(path, fastest_along(path, limits, intervals));
    const double worst = std::max(motion.peak(0, 2), motion.peak(1, 2));
    CHECK(worst <= allowed);
    CHECK(worst <= before);
    before = worst;
    // The positions where it goes are on the circle.
    for (double t = 0.0; t <= motion.duration(); t += motion.duration() / 100.0) {
      CHECK(std::hypot(motion.value(0, t), motion.value(1, t)) ==
            doctest::Approx(1.0).epsilon(1e-7));
    }
  }
}

TEST_CASE("limits hold everywhere, rest at both ends, and all points are passed") {
  std::mt19937_64 generator(2);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const int n = 1 + static_cast<int>(generator() % 7);
    const Trajectory path = random_path(generator, n, 8);
    const std::vector<AxisLimits> limits = random_limits(generator, n);
    const Trajectory motion = time_optimal(path, limits, 100);
    for (int sample = 0; sample <= 3000; ++sample) {
      CHECK(load(motion, limits, motion.duration() * sample / 3000.0) <= 1.0 + 1e-9);
    }
    for (int i = 0; i < n; ++i) {
      CHECK(std::abs(motion.value(i, 0.0, 1)) < 1e-12);
      CHECK(std::abs(motion.value(i, motion.duration(), 1)) < 1e-7);
      CHECK(motion.continuity(i, 1e-7) >= 1);
      CHECK(motion.range(i).upper == doctest::Approx(path.range(i).upper).epsilon(1e-9).scale(1.0));
      CHECK(motion.range(i).lower == doctest::Approx(path.range(i).lower).epsilon(1e-9).scale(1.0));
    }
    CHECK((motion.end() - path.end()).norm() == 0.0);
  }
}

// Calls check(path, limits) for random paths of two to seven joints.
template <class Check>
static void for_random_paths(const Check& check) {
  std::mt19937_64 generator(survey_seed(3));
  for (int k = 0; k < survey_count(30); ++k) {
    CAPTURE(k);
    const int n = 2 + static_cast<int>(generator() % 6);
    const Trajectory path = random_path(generator, n, 8);
    check(path, random_limits(generator, n));
  }
}

// A run is the fastest on its positions if more speed is possible nowhere: in each interval some
// joint is at a limit where it begins or where it ends, for the acceleration along the path does
// not change in between. There the limits are met to rounding. In between they are met the less the
// wider the interval: with 400 intervals one run in twenty-five has less than 98 % of every limit
// for more than a twentieth of its time. Only where speeding up becomes slowing down an interval
// may be at no limit at all, so two such intervals never follow each other.
TEST_CASE("in every interval some joint is at a limit, or the next one slows down") {
  for_random_paths([](const Trajectory& path, const std::vector<AxisLimits>& limits) {
    for (const int intervals : {100, 400}) {
      const SpeedAlongPath run = fastest_along(path, limits, intervals);
      int in_a_row = 0;
      for (std::size_t i = 0; i + 1 < run.s.size(); ++i) {
        const double u = (run.squared[i + 1] - run.squared[i]) / (2.0 * (run.s[i + 1] - run.s[i]));
        const double most = std::max(load_along(path, limits, run.s[i], run.squared[i], u),
                                     load_along(path, limits, run.s[i + 1], run.squared[i + 1], u));
        CHECK(most <= 1.0 + 1e-6);
        in_a_row = most < 1.0 - 1e-6 ? in_a_row + 1 : 0;
        CHECK(in_a_row <= 1);
      }
    }
  });
}

TEST_CASE("at nearly every moment some joint is at a limit") {
  for_random_paths([](const Trajectory& path, const std::vector<AxisLimits>& limits) {
    const Trajectory motion = time_optimal(path, limits, 400);
    int idle = 0;
    for (int sample = 1; sample < 1000; ++sample) {
      idle += load(motion, limits, motion.duration() * sample / 1000.0) < 0.98 ? 1 : 0;
    }
    CHECK(idle <= 50);
  });
}

TEST_CASE("higher limits are never slower, and k times all speeds needs k^2 accelerations") {
  std::mt19937_64 generator(4);
  for (int k = 0; k < 50; ++k) {
    const Trajectory path = random_path(generator, 3, 8);
    std::vector<AxisLimits> limits = random_limits(generator, 3);
    const double T = fastest_along(path, limits).duration();
    std::vector<AxisLimits> scaled = limits;
    for (AxisLimits& l : scaled) l = {2.0 * l.speed, 4.0 * l.acceleration};
    CHECK(fastest_along(path, scaled).duration() == doctest::Approx(0.5 * T).epsilon(1e-9));
    limits[generator() % 3].acceleration *= 1.5;
    CHECK(fastest_along(path, limits).duration() <= T * (1.0 + 1e-9));
  }
}

TEST_CASE("backwards takes as long as forwards") {
  std::mt19937_64 generator(5);
  for (int k = 0; k < 30; ++k) {
    const Trajectory path = random_path(generator, 4, 8);
    const std::vector<AxisLimits> limits = random_limits(generator, 4);
    CHECK(fastest_along(path, limits, 400).duration() ==
          doctest::Approx(fastest_along(path.reversed(), limits, 400).duration()).epsilon(2e-3));
  }
}

TEST_CASE("paths and limits that cannot be used are refused") {
  const std::vector<AxisLimits> good{{1.0, 1.0}};
  const std::vector<AxisLimits> endless{{1.0, INFINITY}};
  CHECK_THROWS_AS((void)fastest_along(straight_line(1.0), endless), ArgumentError);
  CHECK_THROWS_AS((void)fastest_along(straight_line(1.0), {}), ArgumentError);
  CHECK_THROWS_AS((void)fastest_along(straight_line(1.0), good, 0), ArgumentError);
  const Trajectory still = Trajectory::at_rest(Eigen::VectorXd::Zero(1), 0.0);
  CHECK_THROWS_AS((void)fastest_along(still, good), ArgumentError);
  const Segment quintic = quintic_segment({}, {.q = 1.0}, 1.0);
  CHECK_THROWS_AS((void)fastest_along(Trajectory({{{quintic}, 1.0}}, 1.0), good), ArgumentError);
  const std::vector<Eigen::VectorXd> twice(2, Eigen::VectorXd::Ones(2));
  CHECK_THROWS_AS((void)path_through(twice), ArgumentError);
  CHECK_THROWS_AS((void)path_through(std::span(twice).first(1)), ArgumentError);
}
