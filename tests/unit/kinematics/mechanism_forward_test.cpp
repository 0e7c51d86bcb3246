#include "armlet/kinematics/mechanism_forward.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/model/serial_arm.hpp"

using namespace armlet;

TEST_CASE("the Jacobian of a hand with coupled fingers is the central difference of its tips") {
  const Mechanism hand = make_barrett_hand();
  Random random(31);
  for (int k = 0; k < 100; ++k) {
    Eigen::VectorXd q(4);
    for (int a = 0; a < 4; ++a) {
      const Actuator& actuator = hand.actuators()[static_cast<std::size_t>(a)];
      q[a] = random.uniform(actuator.lower, actuator.upper);
    }
    for (const Tip& tip : hand.tips()) {
      const Matrix6Xd J = tip_jacobian(hand, q, tip);
      for (int a = 0; a < 4; ++a) {
        constexpr double h = 1e-6;
        Eigen::VectorXd below = q, above = q;
        below[a] -= h;
        above[a] += h;
        const Vector6d change =
            pose_error(tip_pose(hand, below, tip), tip_pose(hand, above, tip)) / (2 * h);
        CHECK((J.col(a) - change).cwiseAbs().maxCoeff() < 1e-8);
      }
    }
  }
}

TEST_CASE("an arm and the mechanism made of it have the same Jacobian") {
  Random random(32);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    MechanismSpec spec = mechanism_of(robot);
    spec.tips.push_back(
        {"tool", static_cast<int>(spec.bodies.size()) - 1, Eigen::Isometry3d::Identity()});
    const Mechanism mechanism(spec);
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    CHECK((tip_jacobian(mechanism, q, mechanism.tips()[0]) - jacobian(robot, q))
              .cwiseAbs()
              .maxCoeff() < 1e-12);
  }
}

TEST_CASE("a finger of a hand with coupled fingers moves like the arm of its joints") {
  const Mechanism hand = make_barrett_hand();
  MechanismSpec loose = hand.spec();
  loose.actuators.assign(8, {.name = "joint", .lower = -4.0, .upper = 4.0});
  for (std::size_t i = 0; i < 8; ++i) loose.actuators[i].name += std::to_string(i);
  loose.coupling.resize(0, 0);
  loose.offset.resize(0);
  const Mechanism free(loose);
  Random random(33);
  const int first[] = {0, 3, 6};
  const int joints[] = {3, 3, 2};
  for (std::size_t finger = 0; finger < 3; ++finger) {
    const Tip& tip = hand.tips()[finger];
    CAPTURE(tip.name);
    const Result<RobotSpec> spec = serial_arm(free, tip.name);
    REQUIRE(spec.ok());
    const Robot arm(*spec);
    REQUIRE(arm.n() == joints[finger]);
    for (int k = 0; k < 100; ++k) {
      Eigen::VectorXd q(4);
      for (double& value : q) value = random.uniform(0.0, 2.4);
      const Eigen::VectorXd q_finger = hand.joint_values(q).segment(first[finger], joints[finger]);
      CHECK((forward(arm, q_finger).matrix() - tip_pose(hand, q, tip).matrix()).norm() < 1e-12);
      const Eigen::MatrixXd C = hand.spec().coupling.middleRows(first[finger], joints[finger]);
      CHECK((jacobian(arm, q_finger) * C - tip_jacobian(hand, q, tip)).norm() < 1e-12);
    }
  }
}

TEST_CASE("a tip on the base does not move") {
  const Mechanism gripper = make_parallel_gripper();
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.02);
  CHECK(tip_pose(gripper, q, gripper.tip("grasp")).translation().z() == 0.1034);
  CHECK(tip_jacobian(gripper, q, gripper.tip("grasp")).isZero(0.0));
  CHECK_THROWS_AS(body_frames(gripper, Eigen::Vector2d::Zero()), ArgumentError);
}
