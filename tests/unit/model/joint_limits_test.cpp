#include "armlet/model/joint_limits.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

#include "armlet/core/error.hpp"
#include "armlet/model/robot.hpp"

using namespace armlet;

TEST_CASE("a joint without limits rotates once in either direction or slides a metre") {
  const Joint turning = joint_without_limits(JointKind::kRevolute);
  CHECK(turning.is_revolute());
  CHECK(turning.lower == -2.0 * std::numbers::pi);
  CHECK(turning.upper == 2.0 * std::numbers::pi);
  const Joint sliding = joint_without_limits(JointKind::kPrismatic);
  CHECK_FALSE(sliding.is_revolute());
  CHECK(sliding.lower == 0.0);
  CHECK(sliding.upper == 1.0);
}

TEST_CASE("a table of limits goes to the joints row by row") {
  std::vector<Joint> joints = joints_from_table({{0, 0.35, 0.4, 0}, {0, 0, 0, 0}}, "RP");
  set_limits(joints, {{-2.5, 2.0}, {0.1, 0.2}});
  CHECK(joints[0].lower == -2.5);
  CHECK(joints[0].upper == 2.0);
  CHECK(joints[1].lower == 0.1);
  CHECK(joints[1].upper == 0.2);
}

TEST_CASE("limits of another number of joints, and rows that are no pair, are refused") {
  std::vector<Joint> joints = joints_from_table({{0, 0.35, 0.4, 0}, {0, 0, 0, 0}}, "RP");
  CHECK_THROWS_AS(set_limits(joints, {}), ArgumentError);
  CHECK_THROWS_AS(set_limits(joints, {{-1.0, 1.0}}), ArgumentError);
  CHECK_THROWS_AS(set_limits(joints, {{-1.0, 1.0}, {0.0}}), ArgumentError);
  set_limits(joints, {{1.0, -1.0}, {0.0, 0.1}});
  CHECK_THROWS_AS(Robot({.joints = joints}), ArgumentError);
  set_limits(joints, {{-1.0, std::numeric_limits<double>::quiet_NaN()}, {0.0, 0.1}});
  CHECK_THROWS_AS(Robot({.joints = joints}), ArgumentError);
}
