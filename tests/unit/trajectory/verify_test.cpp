#include "armlet/trajectory/verify.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/profile.hpp"

using namespace armlet;

namespace {

// Joint 1 follows the piece, the others stand still.
Trajectory first_joint(const Robot& robot, const Segment& piece) {
  std::vector<JointPath> joints(static_cast<std::size_t>(robot.n()));
  joints[0] = {.segments = {piece}, .q_end = piece.value(piece.duration)};
  return {std::move(joints), piece.duration};
}

}  // namespace

TEST_CASE("a slow motion within the limits passes unchanged") {
  const Robot robot = *make_robot("scara");
  const MotionPlan plan = verify(robot, first_joint(robot, quintic_segment({}, {.q = 0.5}, 5.0)));
  CHECK(plan.ok());
  CHECK_FALSE(plan.too_fast.has_value());
  CHECK(plan.trajectory->duration() == 5.0);
}

TEST_CASE("a path that leaves the limits between its ends is found") {
  const Robot robot = *make_robot("scara");
  // Up to 1.5 * upper and back, ends at zero.
  const double top = 1.5 * robot.upper()[0];
  const Segment hill{.duration = 20.0, .degree = 2, .c = {0.0, 0.2 * top, -0.01 * top}};
  const MotionPlan plan = verify(robot, first_joint(robot, hill));
  CHECK_FALSE(plan.ok());
  REQUIRE(plan.outside.size() == 1);
  CHECK(plan.outside[0].joint == 0);
  CHECK(plan.outside[0].value == doctest::Approx(top).epsilon(1e-12));
  CHECK(plan.outside[0].limit == robot.upper()[0]);
}

TEST_CASE("a joint that starts outside may only come back") {
  const Robot robot = *make_robot("scara");
  const double out = robot.upper()[0] + 0.1;
  CHECK(verify(robot, first_joint(robot, quintic_segment({.q = out}, {.q = 0.0}, 9.0))).ok());
  CHECK_FALSE(
      verify(robot, first_joint(robot, quintic_segment({.q = out}, {.q = out + 0.01}, 9.0))).ok());
}

TEST_CASE("the least time is the one at which the path just keeps the limits") {
  const Robot robot = *make_robot("scara");
  const Trajectory fast = first_joint(robot, quintic_segment({}, {.q = 1.0}, 0.1));
  const MotionPlan refused = verify(robot, fast);
  CHECK_FALSE(refused.ok());
  REQUIRE(refused.too_fast.has_value());
  CHECK(refused.too_fast->joint == 0);
  CHECK(refused.too_fast->given == 0.1);
  CHECK(refused.too_fast->travel == 1.0);
  CHECK(verify(robot, fast.stretched(refused.too_fast->least_time / 0.1)).ok());
  CHECK_FALSE(verify(robot, fast.stretched(refused.too_fast->least_time / 0.1001)).ok());
  const MotionPlan advised = verify(robot, fast, false);
  CHECK(advised.ok());
  CHECK(advised.too_fast.has_value());
}

TEST_CASE("a trajectory for another number of joints is refused") {
  CHECK_THROWS_AS((void)verify(*make_robot("scara"), Trajectory({}, 1.0)), ArgumentError);
}
