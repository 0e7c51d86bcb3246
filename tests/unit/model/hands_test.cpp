#include "armlet/model/hands.hpp"

#include <doctest/doctest.h>

#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/math/angles.hpp"

using namespace armlet;

namespace {

Eigen::Vector3d tip_of(const Mechanism& hand, const Eigen::VectorXd& q, const char* name) {
  return tip_pose(hand, q, hand.tip(name)).translation();
}

Eigen::Vector3d mirrored(Eigen::Vector3d p) {
  p.x() = -p.x();
  return p;
}

}  // namespace

TEST_CASE("every gripper is there under its name") {
  for (const std::string_view name : hand_names()) {
    CAPTURE(name);
    const auto hand = make_hand(name);
    REQUIRE(hand);
    CHECK(hand->name == name);
    CHECK_FALSE(hand->source.empty());
    if (hand->mechanism) CHECK(hand->mechanism->name() == name);
  }
  CHECK_FALSE(make_hand("hook"));
}

// Lengths: Barrett BH8-280.
TEST_CASE("the flat Barrett hand reaches as far as its links are long") {
  const Mechanism hand = make_barrett_hand();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(4);
  const double bent = 0.05 / std::sqrt(2.0);
  const double out = 0.05 + 0.06994 + bent, up = 0.0415 + 0.0339 + bent;
  CHECK((tip_of(hand, zero, "tip1") - Eigen::Vector3d(-0.025, out, up)).norm() < 1e-12);
  CHECK((tip_of(hand, zero, "tip2") - Eigen::Vector3d(0.025, out, up)).norm() < 1e-12);
  CHECK((tip_of(hand, zero, "tip3") - Eigen::Vector3d(0, -out, up)).norm() < 1e-12);
}

TEST_CASE("fingers 1 and 2 of the Barrett hand mirror each other at every spread") {
  const Mechanism hand = make_barrett_hand();
  for (const double spread : {0.0, 30.0, 90.0, 180.0}) {
    for (const double bend : {0.0, 45.0, 140.0}) {
      Eigen::VectorXd q(4);
      q << deg_to_rad(spread), deg_to_rad(bend), deg_to_rad(bend), deg_to_rad(bend);
      CHECK((tip_of(hand, q, "tip1") - mirrored(tip_of(hand, q, "tip2"))).norm() < 1e-12);
    }
  }
}

TEST_CASE("all fingers of the Barrett hand lie on one side at a spread of 180 degrees") {
  const Mechanism hand = make_barrett_hand();
  Eigen::VectorXd q(4);
  q << kPi, 0.6, 0.6, 0.6;
  const Eigen::Vector3d one = tip_of(hand, q, "tip1"), three = tip_of(hand, q, "tip3");
  CHECK(std::abs(one.y() - three.y()) < 1e-12);
  CHECK(std::abs(one.z() - three.z()) < 1e-12);
  CHECK(one.x() == doctest::Approx(-0.025));
}

TEST_CASE("the last link of a Barrett finger rotates a third as far as the one before it") {
  const Mechanism hand = make_barrett_hand();
  Eigen::VectorXd q(4);
  q << 0.1, 0.9, 0.6, 0.3;
  const Eigen::VectorXd joints = hand.joint_values(q);
  CHECK(joints[2] == doctest::Approx(0.3));
  CHECK(joints[5] == doctest::Approx(0.2));
  CHECK(joints[7] == doctest::Approx(0.1));
}

TEST_CASE("the fingers of the parallel gripper open to the width that is asked for") {
  const Mechanism gripper = make_parallel_gripper();
  const auto frames = body_frames(gripper, Eigen::VectorXd::Constant(1, 0.06));
  CHECK((frames[0].translation() - frames[1].translation() - Eigen::Vector3d(0, 0.06, 0)).norm() <
        1e-15);
}
