#include "armlet/trajectory/accelerations.hpp"

#include <doctest/doctest.h>

#include <random>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/planner.hpp"

using namespace armlet;

namespace {

MoveRequest request_for(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  MoveRequest request;
  request.q0 = Eigen::VectorXd(3);
  request.q1 = Eigen::VectorXd(3);
  for (double& q : request.q0) q = unit(random);
  for (double& q : request.q1) q = unit(random);
  request.limits = {{1.0, 2.0, 9.0}, {2.0, 3.0, 30.0}, {0.5, 4.0, 20.0}};
  return request;
}

}  // namespace

TEST_CASE("the acceleration parameters of every planner give its second derivative") {
  std::mt19937_64 random(11);
  const PlannerSet planners;
  for (const std::string& name : planners.names()) {
    CAPTURE(name);
    const Trajectory motion = *planners.plan(name, request_for(random)).trajectory;
    const std::vector<double> knots = motion.knots();
    for (int i = 0; i < motion.n(); ++i) {
      const auto pieces = acceleration_pieces(motion, i);
      REQUIRE(pieces.size() == knots.size() - 1);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        CHECK(pieces[k].start == knots[k]);
        const double t = knots[k] + 0.3 * (knots[k + 1] - knots[k]);
        CHECK(pieces[k].value(t - knots[k]) ==
              doctest::Approx(motion.value(i, t, 2)).epsilon(1e-9).scale(1.0));
      }
    }
  }
}

// Fu, Gonzalez, Lee: Robotics, 1987, section 4.3; the numbers by solving the fourteen conditions.
TEST_CASE("the 4-3-4 from 0 by 0.1 and 0.9 to 1 has these acceleration parameters") {
  const PlannerSet planners;
  MoveRequest request;
  request.q0 = Eigen::VectorXd::Zero(1);
  request.q1 = Eigen::VectorXd::Ones(1);
  request.limits = {AxisLimits{}};
  request.time = 2.0;
  const auto pieces = acceleration_pieces(*planners.plan("434", request).trajectory, 0);
  REQUIRE(pieces.size() == 3);
  const auto check = [](const Segment& piece, double a0, double a1, double a2) {
    CHECK(piece.value(0.0, 0) == doctest::Approx(a0).scale(1.0));
    CHECK(piece.value(0.0, 1) == doctest::Approx(a1).scale(1.0));
    CHECK(piece.value(0.0, 2) / 2.0 == doctest::Approx(a2).scale(1.0));
  };
  check(pieces[0], 0.0, 6.4, -6.4);
  check(pieces[1], 1.6, -3.2, 0.0);
  check(pieces[2], -1.6, 0.0, 6.4);
}

TEST_CASE("a motion without time has no acceleration parameters, and no joint beyond its own") {
  const Trajectory still = Trajectory::at_rest(Eigen::Vector2d(1.0, 2.0), 0.0);
  CHECK(acceleration_pieces(still, 1).empty());
  CHECK_THROWS_AS(static_cast<void>(acceleration_pieces(still, 2)), ArgumentError);
  CHECK_THROWS_AS(static_cast<void>(acceleration_pieces(still, -1)), ArgumentError);
}
