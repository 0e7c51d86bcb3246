#include "armlet/chain/walk_plan.hpp"

#include <doctest/doctest.h>

#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;

TEST_CASE("the twists of common arms need no arithmetic") {
  for (const char* name : {"puma560", "ur5", "panda", "scara", "stanford"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (std::size_t i = 1; i < static_cast<std::size_t>(robot.n()); ++i) {
      CHECK(robot.walk_plan().twist[i] != LinkTwist::kAny);
    }
  }
}

TEST_CASE("a link twist that reverses the frames changes only signs") {
  Random random(1);
  for (int k = 0; k < 500; ++k) {
    const Robot robot = random_arm(random, 1 + k % kMaxJoints);
    const Chain& chain = robot.chain();
    const WalkPlan& plan = robot.walk_plan();
    for (std::size_t i = 0; i < static_cast<std::size_t>(robot.n()); ++i) {
      CHECK(std::abs(plan.flip[i]) == 1.0);
      CHECK(plan.theta[i] == plan.flip[i] * chain.theta[i]);
      CHECK(plan.d[i] == plan.flip[i] * chain.d[i]);
      if (i == 0) continue;
      CHECK(plan.sin_alpha[i] >= 0.0);
      CHECK(plan.flip[i] * plan.cos_alpha[i] == plan.flip[i - 1] * chain.cos_alpha[i]);
      CHECK(plan.flip[i] * plan.sin_alpha[i] == plan.flip[i - 1] * chain.sin_alpha[i]);
    }
  }
}
