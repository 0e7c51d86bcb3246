#pragma once

#include <doctest/doctest.h>

#include "armlet/model/robot.hpp"

namespace armlet {

// An arm that was made of a description of `robot` has its joints, ranges and speeds, bit by bit.
inline void check_same_joints(const Robot& again, const Robot& robot) {
  REQUIRE(again.n() == robot.n());
  CHECK(again.lower() == robot.lower());
  CHECK(again.upper() == robot.upper());
  CHECK(again.max_speed() == robot.max_speed());
}

}  // namespace armlet
