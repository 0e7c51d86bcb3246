#include "armlet/trajectory/planner.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <set>

#include "armlet/core/error.hpp"
#include "uniform.hpp"

using namespace armlet;

namespace {

MoveRequest random_request(std::mt19937_64& generator, int n) {
  MoveRequest request;
  request.q0.resize(n);
  request.q1.resize(n);
  for (int i = 0; i < n; ++i) {
    request.q0[i] = uniform(generator, -3.0, 3.0);
    request.q1[i] = generator() % 5 == 0 ? request.q0[i] : uniform(generator, -3.0, 3.0);
    request.limits.push_back({.speed = uniform(generator, 0.5, 4.0),
                              .acceleration = uniform(generator, 1.0, 20.0),
                              .jerk = uniform(generator, 10.0, 200.0)});
  }
  return request;
}

const PlannerSet kPlanners;

}  // namespace

TEST_CASE("every row is a planner with a name of its own and says what it does") {
  std::set<std::string_view> names;
  for (const PlannerRow& row : planner_rows()) {
    CAPTURE(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(kPlanners.has(row.name));
    CHECK_FALSE(row.does.empty());
    CHECK_FALSE(row.does.ends_with('.'));
  }
  CHECK(kPlanners.names().size() == planner_rows().size());
  CHECK(kPlanners.has("434"));
  CHECK_FALSE(kPlanners.has("Sin"));
  CHECK_THROWS_AS((void)kPlanners.plan("Sin", {}), ArgumentError);
}

TEST_CASE("a registered planner is found by its name and can replace another") {
  PlannerSet planners;
  planners.add("Jump", [](const MoveRequest& request) {
    return Plan{.trajectory = Trajectory::at_rest(request.q1, 1.0)};
  });
  planners.add("Syn", [](const MoveRequest& request) {
    return Plan{.trajectory = Trajectory::at_rest(request.q1, 7.0)};
  });
  CHECK(planners.plan("Jump", {}).trajectory->duration() == 1.0);
  CHECK(planners.plan("Syn", {}).trajectory->duration() == 7.0);
  CHECK(planners.names().size() == kPlanners.names().size() + 1);
}

TEST_CASE("every planner starts and ends at rest on the exact targets, within every limit") {
  std::mt19937_64 generator(11);
  for (const std::string& name : kPlanners.names()) {
    CAPTURE(name);
    for (int k = 0; k < 200; ++k) {
      const MoveRequest request = random_request(generator, 1 + static_cast<int>(generator() % 7));
      const Plan plan = kPlanners.plan(name, request);
      REQUIRE(plan.trajectory.has_value());
      CHECK_FALSE(plan.too_fast.has_value());
      const Trajectory& motion = *plan.trajectory;
      CHECK(motion.start() == request.q0);
      CHECK(motion.end() == request.q1);
      for (int i = 0; i < motion.n(); ++i) {
        const AxisLimits& limits = request.limits[static_cast<size_t>(i)];
        CHECK(motion.peak(i, 1) <= limits.speed * (1.0 + 1e-9));
        CHECK(motion.peak(i, 2) <= limits.acceleration * (1.0 + 1e-9));
        if (name != "Lin0") CHECK(std::abs(motion.value(i, motion.duration(), 1)) < 1e-9);
        // Positions meet at the knots, the last of them on the target.
        for (const Segment& piece : motion.joint(i).segments) {
          CHECK(piece.value(piece.duration) ==
                doctest::Approx(motion.value(i, piece.end())).epsilon(1e-9));
        }
      }
    }
  }
}

TEST_CASE("Syn, Cubic, Trap and Lin end together; Asyn lets joints arrive early") {
  MoveRequest request{.q0 = Eigen::Vector2d(0.0, 0.0), .q1 = Eigen::Vector2d(1.0, 0.2)};
  request.limits = {{.speed = 1.0}, {.speed = 1.0}};
  for (const char* name : {"Syn", "Cubic"}) {
    const Plan plan = kPlanners.plan(name, request);
    CHECK(plan.trajectory->joint(0).segments.back().end() ==
          plan.trajectory->joint(1).segments.back().end());
  }
  const Plan plan = kPlanners.plan("Asyn", request);
  CHECK(plan.trajectory->duration() == doctest::Approx(1.875));
  CHECK(plan.trajectory->joint(1).segments.back().end() == doctest::Approx(0.375));
  request.time = 3.75;
  const Plan slow = kPlanners.plan("Asyn", request);
  CHECK(slow.trajectory->duration() == 3.75);
  CHECK(slow.trajectory->joint(1).segments.back().end() == doctest::Approx(0.75));
}

TEST_CASE("Lin stays on the straight line in joint space and cruises at constant speed") {
  std::mt19937_64 generator(12);
  for (int k = 0; k < 100; ++k) {
    const MoveRequest request = random_request(generator, 4);
    const Trajectory motion = *kPlanners.plan("Lin", request).trajectory;
    const Eigen::VectorXd D = request.q1 - request.q0;
    int longest = 0;
    D.cwiseAbs().maxCoeff(&longest);
    for (double t = 0.0; t <= motion.duration(); t += motion.duration() / 37.0) {
      const double s = (motion.value(longest, t) - request.q0[longest]) / D[longest];
      for (int i = 0; i < 4; ++i) {
        CHECK(std::abs(motion.value(i, t) - request.q0[i] - s * D[i]) < 1e-12);
      }
    }
  }
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {{.speed = 2.0, .acceleration = 100.0}};
  request.time = 1.0;
  const Trajectory motion = *kPlanners.plan("Lin", request).trajectory;
  // V = (A T - sqrt(A^2 T^2 - 4 A D)) / 2, ramps of V / A.
  CHECK(motion.value(0, 0.5, 1) == doctest::Approx(1.010205144336438).epsilon(1e-12));
  CHECK(motion.value(0, 0.02, 2) == 0.0);
}

TEST_CASE("Trap with a time speeds up for a quarter of it") {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {{.speed = 3.0, .acceleration = 30.0}};
  request.time = 2.0;
  const Trajectory motion = *kPlanners.plan("Trap", request).trajectory;
  CHECK(motion.knots() == std::vector<double>{0.0, 0.5, 1.5, 2.0});
  CHECK(motion.value(0, 1.0, 1) == doctest::Approx(2.0 / 3.0));
}

TEST_CASE("running the move backwards is the same motion with time reversed") {
  std::mt19937_64 generator(13);
  for (const std::string& name : kPlanners.names()) {
    CAPTURE(name);
    if (name == "Seq") continue;  // backwards, the first joint would have to come last
    MoveRequest request = random_request(generator, 3);
    const Trajectory there = *kPlanners.plan(name, request).trajectory;
    std::swap(request.q0, request.q1);
    const Trajectory back = *kPlanners.plan(name, request).trajectory;
    CHECK(there.duration() == doctest::Approx(back.duration()).epsilon(1e-12));
    for (double t = 0.0; t <= there.duration(); t += there.duration() / 50.0) {
      for (int i = 0; i < 3; ++i) {
        CHECK(there.value(i, t) ==
              doctest::Approx(back.value(i, there.duration() - t)).epsilon(1e-10).scale(1.0));
      }
    }
  }
}

TEST_CASE("too short a time names the joint, its travel, its limit and the least time") {
  MoveRequest request{.q0 = Eigen::Vector2d(0.0, 0.0), .q1 = Eigen::Vector2d(0.1, -2.0)};
  request.limits = {{.speed = 1.0}, {.speed = 1.5, .acceleration = 1000.0, .jerk = 1e6}};
  request.time = 2.0;
  for (const auto& [name, least] :
       {std::pair{"Syn", 2.5}, {"Asyn", 2.5}, {"Cubic", 2.0}, {"Lin", 2.0 / 1.5 + 1.5e-3}}) {
    const auto& shown = name;  // clang 14 captures no binding
    CAPTURE(shown);
    request.time = 0.999 * least;
    const Plan plan = kPlanners.plan(name, request);
    CHECK_FALSE(plan.trajectory.has_value());
    REQUIRE(plan.too_fast.has_value());
    CHECK(plan.too_fast->joint == 1);
    CHECK(plan.too_fast->travel == -2.0);
    CHECK(plan.too_fast->limit == 1.5);
    CHECK(plan.too_fast->kind == LimitKind::kSpeed);
    CHECK(plan.too_fast->given == *request.time);
    CHECK(plan.too_fast->least_time == doctest::Approx(least).epsilon(1e-12));
    request.time = plan.too_fast->least_time;
    CHECK(kPlanners.plan(name, request).trajectory.has_value());
  }
}

TEST_CASE("without enforcement a fast move is planned and only reported") {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {{.speed = 0.1, .acceleration = 0.1, .jerk = 1.0}};
  request.time = 0.5;
  request.enforce_limits = false;
  for (const std::string& name : kPlanners.names()) {
    CAPTURE(name);
    const Plan plan = kPlanners.plan(name, request);
    REQUIRE(plan.trajectory.has_value());
    CHECK(plan.trajectory->duration() == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(plan.too_fast.has_value());
    CHECK(plan.trajectory->end()[0] == 1.0);
  }
  request.time = 0.0;
  for (const std::string& name : kPlanners.names()) {
    CHECK_FALSE(kPlanners.plan(name, request).trajectory.has_value());
  }
}

TEST_CASE("a fraction of the speed is the move within that fraction of the speed limits") {
  std::mt19937_64 generator(14);
  std::uniform_real_distribution<double> fraction(0.05, 1.0);
  for (const std::string& name : kPlanners.names()) {
    for (int k = 0; k < 40; ++k) {
      MoveRequest request = random_request(generator, 3);
      request.q1[0] = request.q0[0] + 1.0;
      request.speed = fraction(generator);
      const Trajectory motion = *kPlanners.plan(name, request).trajectory;
      for (int i = 0; i < motion.n(); ++i) {
        const AxisLimits& limits = request.limits[static_cast<std::size_t>(i)];
        CHECK(motion.peak(i, 1) <= *request.speed * limits.speed * (1.0 + 1e-6));
      }
      MoveRequest scaled = request;
      for (AxisLimits& limits : scaled.limits) limits.speed *= *request.speed;
      scaled.speed.reset();
      CHECK(motion.duration() == kPlanners.plan(name, scaled).trajectory->duration());
    }
  }
}

TEST_CASE("a move that never comes near its speed limits is as fast at half the speed") {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Constant(1, 0.01)};
  request.limits = {{.speed = 3.0, .acceleration = 1.0, .jerk = 100.0}};
  const double fastest = kPlanners.plan("Trap", request).trajectory->duration();
  CHECK(fastest == doctest::Approx(0.2));  // 2 sqrt(D / A)
  request.speed = 0.5;
  CHECK(kPlanners.plan("Trap", request).trajectory->duration() == fastest);
  // At 0.1 rad/s it ramps for 0.1 s and cruises for none: the least fraction without effect.
  request.speed = 0.1 / 3.0 / 2.0;
  CHECK(kPlanners.plan("Trap", request).trajectory->duration() ==
        doctest::Approx(0.01 / 0.05 + 0.05));  // D / V + V / A
}

TEST_CASE("no travel takes no time, or stands still for the given time") {
  MoveRequest request{.q0 = Eigen::Vector2d(0.3, 0.4), .q1 = Eigen::Vector2d(0.3, 0.4)};
  request.limits = {{.speed = 1.0}, {.speed = 1.0}};
  for (const std::string& name : kPlanners.names()) {
    request.time.reset();
    CHECK(kPlanners.plan(name, request).trajectory->duration() == 0.0);
    request.time = 1.5;
    const Plan plan = kPlanners.plan(name, request);
    CHECK(plan.trajectory->duration() == 1.5);
    CHECK(plan.trajectory->value(0, 0.7) == 0.3);
  }
  CHECK(kPlanners.plan("Syn", {.time = 2.0}).trajectory->n() == 0);
}

TEST_CASE("wrong sizes, times, speeds and limits are refused") {
  MoveRequest good{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  good.limits = {{.speed = 1.0}};
  const auto refused = [&](auto change) {
    MoveRequest request = good;
    change(request);
    CHECK_THROWS_AS((void)kPlanners.plan("Syn", request), ArgumentError);
  };
  refused([](MoveRequest& r) { r.q1.resize(2); });
  refused([](MoveRequest& r) { r.limits.clear(); });
  refused([](MoveRequest& r) { r.q1[0] = std::nan(""); });
  refused([](MoveRequest& r) { r.time = -1.0; });
  refused([](MoveRequest& r) { r.time = INFINITY; });
  refused([](MoveRequest& r) { r.time = std::nan(""); });
  refused([](MoveRequest& r) { r.speed = 0.0; });
  refused([](MoveRequest& r) { r.speed = 1.5; });
  refused([](MoveRequest& r) { r.time = 1.0, r.speed = 0.5; });
  refused([](MoveRequest& r) { r.limits[0].speed = 0.0; });
  refused([](MoveRequest& r) { r.limits[0] = {}; });
}

TEST_CASE("planners are as smooth at every knot as their law promises") {
  std::mt19937_64 generator(15);
  for (const PlannerRow& row : planner_rows()) {
    CAPTURE(row.name);
    for (int k = 0; k < 50; ++k) {
      const MoveRequest request = random_request(generator, 3);
      const Trajectory motion = *kPlanners.plan(row.name, request).trajectory;
      for (int i = 0; i < 3; ++i) {
        if (request.q0[i] == request.q1[i]) continue;
        CHECK(motion.continuity(i, 1e-7) == row.smooth);
      }
    }
  }
}

TEST_CASE("through several points every planner passes them, within every limit") {
  std::mt19937_64 generator(16);
  for (const std::string& name : kPlanners.names()) {
    CAPTURE(name);
    for (int k = 0; k < 50; ++k) {
      MoveRequest request = random_request(generator, 3);
      request.via = {random_request(generator, 3).q0, random_request(generator, 3).q0};
      const Trajectory motion = *kPlanners.plan(name, request).trajectory;
      for (int i = 0; i < 3; ++i) {
        const AxisLimits& limits = request.limits[static_cast<size_t>(i)];
        CHECK(motion.peak(i, 1) <= limits.speed * (1.0 + 1e-9));
        CHECK(motion.peak(i, 2) <= limits.acceleration * (1.0 + 1e-9));
      }
      CHECK(motion.end() == request.q1);
      if (name == "Fastest") continue;  // divides the time by itself
      // Each point is passed at its time.
      request.durations = {2.0, 3.0, 4.0};
      request.enforce_limits = false;
      const Trajectory timed = *kPlanners.plan(name, request).trajectory;
      CHECK(timed.duration() == 9.0);
      for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(timed.value(i, 2.0) - request.via[0][i]) < 1e-9);
        CHECK(std::abs(timed.value(i, 5.0) - request.via[1][i]) < 1e-9);
      }
    }
  }
}

TEST_CASE("Seq moves one joint at a time") {
  MoveRequest request{.q0 = Eigen::Vector3d(0.0, 0.0, 0.0), .q1 = Eigen::Vector3d(1.0, 0.0, 2.0)};
  request.limits = {{.speed = 1.0}, {.speed = 1.0}, {.speed = 1.0}};
  const Trajectory motion = *kPlanners.plan("Seq", request).trajectory;
  CHECK(motion.duration() == doctest::Approx(3.0 * 1.875));
  for (double t = 0.0; t < motion.duration(); t += 0.1) {
    CHECK(motion.value(0, t, 1) * motion.value(2, t, 1) == 0.0);
  }
  request.time = 1.0;
  const Plan fast = kPlanners.plan("Seq", request);
  REQUIRE(fast.too_fast);
  CHECK(fast.too_fast->joint == 2);
  CHECK(fast.too_fast->least_time == doctest::Approx(5.625));
}

TEST_CASE("434 through two points lifts off and sets down by a tenth in a quarter of the time") {
  MoveRequest request{.q0 = Eigen::VectorXd::Zero(1), .q1 = Eigen::VectorXd::Ones(1)};
  request.limits = {{.speed = 10.0}};
  request.time = 2.0;
  const Trajectory motion = *kPlanners.plan("434", request).trajectory;
  CHECK(motion.knots() == std::vector<double>{0.0, 0.5, 1.5, 2.0});
  CHECK(motion.value(0, 0.5) == doctest::Approx(0.1).epsilon(1e-14));
  CHECK(motion.value(0, 1.0, 1) == doctest::Approx(14.0 / 15.0).epsilon(1e-14));
  request.via = {Eigen::VectorXd::Ones(1) * 0.5};
  CHECK_THROWS_AS((void)kPlanners.plan("434", request), ArgumentError);
  request.durations = {1.0};
  CHECK_THROWS_AS((void)kPlanners.plan("Syn", request), ArgumentError);
}

TEST_CASE(
    "Fastest passes every point, meets a limit at every moment, and needs no more than others") {
  std::mt19937_64 generator(29);
  for (int trial = 0; trial < 40; ++trial) {
    MoveRequest request = random_request(generator, 3);
    request.via = {random_request(generator, 3).q0, random_request(generator, 3).q0};
    const Trajectory fastest = *kPlanners.plan("Fastest", request).trajectory;
    const double T = fastest.duration();
    std::size_t passed = 0;
    double mean = 0.0;
    for (int k = 0; k <= 20000; ++k) {
      double load = 0.0, apart = 0.0;
      for (int i = 0; i < 3; ++i) {
        const AxisLimits& limits = request.limits[static_cast<size_t>(i)];
        load = std::max({load, std::abs(fastest.value(i, k * T / 20000, 1)) / limits.speed,
                         std::abs(fastest.value(i, k * T / 20000, 2)) / limits.acceleration});
        if (passed < 2)
          apart =
              std::max(apart, std::abs(fastest.value(i, k * T / 20000) - request.via[passed][i]));
      }
      CHECK(load <= 1.0 + 1e-9);
      mean += load / 20001;
      if (passed < 2 && apart < 2e-3) ++passed;
    }
    CHECK(passed == 2);
    CHECK(mean > 0.75);
    CHECK(T < kPlanners.plan("Spline3", request).trajectory->duration());
  }
  MoveRequest timed = random_request(generator, 3);
  timed.durations = {1.0};
  CHECK_THROWS_AS((void)kPlanners.plan("Fastest", timed), ArgumentError);
}
