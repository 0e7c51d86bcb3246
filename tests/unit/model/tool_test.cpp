#include "armlet/model/tool.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"

using namespace armlet;

TEST_CASE("grippers have the lengths of the language reference by default") {
  CHECK(parallel_gripper(0.06).length == 0.120);
  CHECK(parallel_gripper(0.06).force == 20.0);
  CHECK(suction_cup(0.01).length == 0.060);
  CHECK(parallel_gripper(0.06).grasp_distance == 0.005);
}

TEST_CASE("grippers and suction cups can grasp, a point and no tool cannot") {
  CHECK(parallel_gripper(0.06).can_grasp());
  CHECK(suction_cup(0.01).can_grasp());
  CHECK_FALSE(point_tool().can_grasp());
  CHECK_FALSE(Tool{}.can_grasp());
}

TEST_CASE("impossible grippers are refused") {
  CHECK_THROWS_AS(parallel_gripper(0.0), ArgumentError);
  CHECK_THROWS_AS(parallel_gripper(0.06, -0.1), ArgumentError);
  CHECK_THROWS_AS(parallel_gripper(0.06, 0.1, NAN), ArgumentError);
  CHECK_THROWS_AS(suction_cup(-0.01), ArgumentError);
}
