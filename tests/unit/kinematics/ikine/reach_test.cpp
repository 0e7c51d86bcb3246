#include "armlet/kinematics/reach.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

TEST_CASE("planar arms reach as far as their links are long") {
  CHECK(find_reach(*make_robot("planar2")).from_base == doctest::Approx(2.0).epsilon(1e-12));
  CHECK(find_reach(*make_robot("planar3")).from_axis == doctest::Approx(0.9).epsilon(1e-12));
}

TEST_CASE("a SCARA reaches the sum of its arms from its column") {
  CHECK(find_reach(*make_robot("scara")).from_axis == doctest::Approx(0.7).epsilon(1e-12));
}

// Straight up or out: the elbow arm's upper arm and forearm in line.
TEST_CASE("an elbow arm reaches farthest with its arm straight") {
  const Reach reach = find_reach(*make_robot("anthropomorphic"));
  CHECK(reach.from_axis == doctest::Approx(0.8).epsilon(1e-9));
  CHECK(reach.from_base == doctest::Approx(1.2).epsilon(1e-9));
}

TEST_CASE("no random configuration of any arm is farther away, and none beyond the bound") {
  Random random(11);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const Reach reach = find_reach(robot);
    CHECK(reach.from_base <= robot.reach() + 1e-12);
    CHECK((reach.q_base.array() >= robot.lower().array()).all());
    CHECK((reach.q_base.array() <= robot.upper().array()).all());
    for (int k = 0; k < 2000; ++k) {
      Eigen::VectorXd q(robot.n());
      for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
      const Eigen::Vector3d p = robot.T_world_base().inverse() * forward(robot, q).translation();
      CHECK(p.norm() <= reach.from_base + 1e-9);
    }
  }
}
