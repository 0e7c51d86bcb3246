#include "armlet/trajectory/law_planner.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"

using namespace armlet;

namespace {

MoveRequest two_joints() {
  MoveRequest request;
  request.q0 = Eigen::Vector2d(0.2, -0.4);
  request.q1 = Eigen::Vector2d(1.4, 0.3);
  request.limits = {{1.0, 2.0, 1e9}, {2.0, 3.0, 1e9}};
  return request;
}

std::vector<double> sampled(double (*law)(double), int pieces) {
  std::vector<double> values;
  for (int k = 0; k <= pieces; ++k) values.push_back(law(static_cast<double>(k) / pieces));
  return values;
}

}  // namespace

TEST_CASE("a law given as the quintic is the built-in one") {
  PlannerSet planners;
  planners.add(
      "Mine",
      planner_of_law(law_of_polynomial(std::vector<double>{0.0, 0.0, 0.0, 10.0, -15.0, 6.0})));
  for (const bool timed : {true, false}) {
    MoveRequest request = two_joints();
    if (timed) request.time = 3.0;
    const Trajectory mine = *planners.plan("Mine", request).trajectory;
    const Trajectory syn = *planners.plan("Syn", request).trajectory;
    CHECK(mine.duration() == doctest::Approx(syn.duration()).epsilon(1e-12));
    for (int i = 0; i < 2; ++i) {
      for (const double x : {0.0, 0.17, 0.5, 0.91, 1.0}) {
        for (int order = 0; order < 4; ++order) {
          CHECK(mine.value(i, x * mine.duration(), order) ==
                doctest::Approx(syn.value(i, x * syn.duration(), order)).epsilon(1e-9).scale(1.0));
        }
      }
    }
  }
}

TEST_CASE("a law given by values meets them, a cubic everywhere") {
  const auto cubic = [](double x) { return x * x * (3.0 - 2.0 * x); };
  const ScalarLaw law = law_of_values(sampled(cubic, 16));
  for (const Segment& piece : law) {
    for (const double u : {0.0, 0.3, 0.9}) {
      const double x = piece.start + u * piece.duration;
      CHECK(piece.value(u * piece.duration) == doctest::Approx(cubic(x)).epsilon(1e-12));
    }
  }
  const auto wave = [](double x) { return 0.5 - 0.5 * std::cos(3.14159265358979323846 * x); };
  for (const Segment& piece : law_of_values(sampled(wave, 64))) {
    const double x = piece.start + 0.5 * piece.duration;
    CHECK(std::abs(piece.value(0.5 * piece.duration) - wave(x)) < 1e-7);
  }
}

TEST_CASE("the fastest motion along a law reaches a limit and exceeds none") {
  PlannerSet planners;
  planners.add("Wave", planner_of_law(law_of_polynomial(std::vector<double>{0.0, 0.0, 3.0, -2.0})));
  const MoveRequest request = two_joints();
  const Trajectory motion = *planners.plan("Wave", request).trajectory;
  double load = 0.0;
  for (int i = 0; i < 2; ++i) {
    const AxisLimits& limits = request.limits[static_cast<std::size_t>(i)];
    load =
        std::max({load, motion.peak(i, 1) / limits.speed, motion.peak(i, 2) / limits.acceleration});
  }
  CHECK(load == doctest::Approx(1.0).epsilon(1e-9));
  MoveRequest hurried = request;
  hurried.time = 0.5 * motion.duration();
  const Plan plan = planners.plan("Wave", hurried);
  CHECK_FALSE(plan.trajectory);
  REQUIRE(plan.too_fast);
  CHECK(plan.too_fast->least_time == doctest::Approx(motion.duration()));
}

TEST_CASE("laws whose acceleration is continuous keep limits on jerk") {
  // D = 10 deg, J = 7200 deg/s^3: T = cbrt(60 D / J) for the quintic, by hand 0.43679 s.
  constexpr double kDeg = 3.14159265358979323846 / 180.0;
  MoveRequest request;
  request.q0 = Eigen::VectorXd::Zero(1);
  request.q1 = Eigen::VectorXd::Constant(1, 10.0 * kDeg);
  request.limits = {{180.0 * kDeg, 720.0 * kDeg, 7200.0 * kDeg}};
  const auto quintic = [](double x) { return x * x * x * (10.0 + x * (6.0 * x - 15.0)); };
  PlannerSet planners;
  planners.add(
      "Polynomial",
      planner_of_law(law_of_polynomial(std::vector<double>{0.0, 0.0, 0.0, 10.0, -15.0, 6.0})));
  planners.add("Values", planner_of_law(law_of_values(sampled(quintic, 64))));
  CHECK(planners.plan("Polynomial", request).trajectory->duration() ==
        doctest::Approx(0.436790).epsilon(1e-5));
  CHECK(planners.plan("Values", request).trajectory->duration() ==
        doctest::Approx(0.436790).epsilon(0.02));
  std::mt19937_64 generator(21);
  std::uniform_real_distribution<double> limit(0.1, 100.0);
  for (const char* name : {"Polynomial", "Values", "ModSine"}) {
    for (int k = 0; k < 100; ++k) {
      request.limits = {{limit(generator), limit(generator), limit(generator)}};
      const Trajectory motion = *planners.plan(name, request).trajectory;
      const AxisLimits& limits = request.limits[0];
      const double load =
          std::max({motion.peak(0, 1) / limits.speed, motion.peak(0, 2) / limits.acceleration,
                    motion.peak(0, 3) / limits.jerk});
      CHECK(load == doctest::Approx(1.0).epsilon(1e-9).scale(1.0));
    }
  }
}

TEST_CASE("a time that is too short for the jerk of a law is refused for it") {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {{1e3, 1e3, 1.0}};
  const PlannerSet planners;
  request.time = 0.5 * planners.plan("ModSine", request).trajectory->duration();
  const Plan plan = planners.plan("ModSine", request);
  CHECK_FALSE(plan.trajectory);
  REQUIRE(plan.too_fast);
  CHECK(plan.too_fast->kind == LimitKind::kJerk);
}

TEST_CASE("a law that does not lead from 0 to 1 is refused") {
  CHECK_THROWS_AS(law_of_polynomial(std::vector<double>{0.0, 2.0}), ArgumentError);
  CHECK_THROWS_AS(law_of_polynomial(std::vector<double>{0.1, 0.9}), ArgumentError);
  CHECK_THROWS_AS(law_of_polynomial(std::vector<double>{}), ArgumentError);
  CHECK_THROWS_AS(law_of_polynomial(std::vector<double>(9, 0.0)), ArgumentError);
  CHECK_THROWS_AS(law_of_values(std::vector<double>{0.0, 0.3, 0.5, 0.7, 1.0}), ArgumentError);
  CHECK_THROWS_AS(law_of_values(std::vector<double>{0.0, std::nan(""), 0.5, 0.6, 0.7, 1.0}),
                  ArgumentError);
}
