#include "armlet/trajectory/part.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/trajectory/planner.hpp"

using namespace armlet;

namespace {

Trajectory through_points() {
  MoveRequest request{.q0 = Eigen::Vector2d(0.1, -0.4), .q1 = Eigen::Vector2d(1.2, 0.7)};
  request.via = {Eigen::Vector2d(0.9, 0.2), Eigen::Vector2d(0.3, 0.9)};
  request.limits = {{.speed = 1.0, .acceleration = 3.0}, {.speed = 2.0, .acceleration = 5.0}};
  return *PlannerSet().plan("Spline5", request).trajectory;
}

}  // namespace

TEST_CASE("a part is the motion between its times, with all derivatives") {
  const Trajectory whole = through_points();
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const double a = random.uniform(0.0, whole.duration());
    const double b = random.uniform(a, whole.duration());
    const Trajectory part = part_of(whole, a, b);
    CHECK(part.duration() == doctest::Approx(b - a).epsilon(1e-12));
    for (int i = 0; i < whole.n(); ++i) {
      for (const double x : {0.01, 0.3, 0.77, 0.99}) {
        for (int order = 0; order <= 3; ++order) {
          CHECK(part.value(i, x * (b - a), order) ==
                doctest::Approx(whole.value(i, a + x * (b - a), order)).epsilon(1e-9));
        }
      }
      CHECK(part.end()[i] == whole.value(i, b));
      CHECK(part.peak(i, 1) <= whole.peak(i, 1) * (1.0 + 1e-12));
    }
  }
}

TEST_CASE("the peaks of the whole are those of its parts") {
  const Trajectory whole = through_points();
  const double T = whole.duration();
  for (int order = 1; order <= 3; ++order) {
    double most = 0.0;
    for (int k = 0; k < 10; ++k)
      most = std::max(most, part_of(whole, T * k / 10.0, T * (k + 1) / 10.0).peak(0, order));
    CHECK(most == doctest::Approx(whole.peak(0, order)).epsilon(1e-9));
  }
}

TEST_CASE("joints that wait at the end of a part stand still there") {
  MoveRequest request{.q0 = Eigen::Vector2d(0.0, 0.0), .q1 = Eigen::Vector2d(1.0, 0.01)};
  request.limits = {{.speed = 1.0, .acceleration = 3.0}, {.speed = 1.0, .acceleration = 3.0}};
  const Trajectory whole = *PlannerSet().plan("Asyn", request).trajectory;
  const double T = whole.duration();
  const Trajectory part = part_of(whole, 0.9 * T, T);
  CHECK(part.duration() == doctest::Approx(0.1 * T).epsilon(1e-12));
  CHECK(part.peak(1, 1) == 0.0);
  CHECK(part.start()[1] == 0.01);
  CHECK(part_of(whole, T, T).duration() == 0.0);
  CHECK_THROWS_AS((void)part_of(whole, -0.1, 0.1), ArgumentError);
  CHECK_THROWS_AS((void)part_of(whole, 0.2, 0.1), ArgumentError);
  CHECK_THROWS_AS((void)part_of(whole, 2.0 * T, 3.0 * T), ArgumentError);
}
