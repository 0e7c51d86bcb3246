#include "armlet/model/serial_arm.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "random_arm.hpp"
#include "reference_robot.hpp"
#include "same_arm.hpp"

using namespace armlet;

namespace {

double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

// Every arm of the catalogue and of the reference files, which mix conventions and joint kinds.
std::vector<Robot> many_arms() {
  std::vector<Robot> arms;
  for (const std::string_view name : catalog_names()) arms.push_back(*make_robot(name));
  for (const std::string& name : reference::arm_names()) {
    arms.push_back(reference::robot_of(reference::load(name).at("robot")));
  }
  return arms;
}

// Total mass, first moment and inertia about the origin of the world: what a scale and a pendulum
// would see of the arm in this position.
struct Bulk {
  double mass = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};
Bulk bulk(const Robot& robot, const Eigen::VectorXd& q) {
  Bulk sum;
  const auto frames = link_frames(robot, q);
  for (int i = 0; i < robot.n(); ++i) {
    const Link& link = robot.link(i);
    const Eigen::Isometry3d& T = frames[static_cast<std::size_t>(i)];
    const Eigen::Vector3d c = T * link.com;
    sum.mass += link.mass;
    sum.moment += link.mass * c;
    sum.inertia += T.linear() * link.inertia * T.linear().transpose() +
                   link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  }
  return sum;
}

}  // namespace

TEST_CASE("an arm and the mechanism made of it have their tools in the same pose") {
  Random random(21);
  for (const Robot& robot : many_arms()) {
    CAPTURE(robot.name());
    const Mechanism mechanism(mechanism_of(robot));
    REQUIRE(mechanism.actuator_count() == robot.n());
    const int tool = mechanism.body("tool");
    for (int k = 0; k < 50; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      const auto frames = body_frames(mechanism, q);
      CHECK(difference(frames[static_cast<std::size_t>(tool)], forward(robot, q)) < 1e-12);
    }
  }
}

TEST_CASE("an arm made of a mechanism has the same tool pose, limits and mass") {
  Random random(22);
  for (const Robot& robot : many_arms()) {
    CAPTURE(robot.name());
    const Result<RobotSpec> spec = serial_arm(Mechanism(mechanism_of(robot)));
    REQUIRE(spec.ok());
    const Robot again(*spec);
    check_same_joints(again, robot);
    for (int k = 0; k < 50; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      CHECK(difference(forward(again, q), forward(robot, q)) < 1e-12);
      const Bulk a = bulk(again, q), b = bulk(robot, q);
      CHECK(std::abs(a.mass - b.mass) < 1e-12);
      CHECK((a.moment - b.moment).cwiseAbs().maxCoeff() < 1e-12 * (1 + b.mass));
      CHECK((a.inertia - b.inertia).cwiseAbs().maxCoeff() < 1e-11 * (1 + b.mass));
    }
  }
}

TEST_CASE("axes in any direction become rows") {
  Random random(23);
  const auto unit = [&] { return random.uniform(-1, 1); };
  for (int k = 0; k < 200; ++k) {
    MechanismSpec spec;
    const int n = 1 + static_cast<int>(random.uniform(0, 7));
    for (int i = 0; i < n; ++i) {
      Body body{
          .name = "b" + std::to_string(i), .joint_name = "j" + std::to_string(i), .parent = i - 1};
      body.joint = unit() > -0.5 ? BodyJoint::kRevolute : BodyJoint::kPrismatic;
      body.T_parent_joint =
          pose_from_rpy({unit(), unit(), unit()}, {3 * unit(), unit(), 3 * unit()});
      body.axis = {unit(), unit(), unit()};
      spec.bodies.push_back(body);
      spec.actuators.push_back({.name = body.joint_name, .lower = -2, .upper = 2});
    }
    const Mechanism mechanism(spec);
    const Result<RobotSpec> arm = serial_arm(mechanism);
    REQUIRE(arm.ok());
    const Robot robot(*arm);
    const Eigen::VectorXd q = random_joints(robot, random);
    CHECK(difference(forward(robot, q), body_frames(mechanism, q).back()) < 1e-9);
  }
}

TEST_CASE("what hangs on a chain without belonging to it counts as its load") {
  MechanismSpec spec = mechanism_of(*make_robot("planar2"));
  Body weight{.name = "weight", .joint_name = "bolt", .parent = 2};
  weight.T_parent_joint = make_translation({0.5, 0, 0});
  weight.link.mass = 3.0;
  spec.bodies.push_back(weight);
  const Result<RobotSpec> arm = serial_arm(Mechanism(spec), "tool");
  REQUIRE(arm.ok());
  CHECK(arm->links[1].mass == doctest::Approx(4.0));
  CHECK(arm->links[0].mass == doctest::Approx(1.0));
}

TEST_CASE("a chain that cannot be an arm is refused with the name of the joint or the choices") {
  const Mechanism hand = make_barrett_hand();
  const auto reason = [&](std::string_view tip) { return serial_arm(hand, tip).error().message; };
  CHECK(reason("").find("several arms") != std::string::npos);
  CHECK(reason("").find("finger3_distal") != std::string::npos);
  CHECK(reason("thumb").find("no link `thumb`") != std::string::npos);
  CHECK(serial_arm(hand, "finger3_medial").ok());
}

TEST_CASE("of two joints of a chain that move together the second copies the first") {
  MechanismSpec spec = mechanism_of(*make_robot("planar2"));
  spec.actuators.pop_back();
  spec.coupling = Eigen::Vector2d(1.0, 1.0);
  spec.offset = Eigen::Vector2d::Zero();
  const Result<RobotSpec> arm = serial_arm(Mechanism(spec));
  REQUIRE(arm.ok());
  REQUIRE(arm->joints.size() == 2);
  CHECK(arm->joints[0].drive.of == -1);
  CHECK(arm->joints[1].drive.of == 0);
  // So do a finger's: its distal joint moves by a third of the medial one.
  const Result<RobotSpec> finger = serial_arm(make_barrett_hand(), "tip1");
  REQUIRE(finger.ok());
  CHECK(finger->joints.back().drive.ratio == doctest::Approx(1.0 / 3.0));
}

TEST_CASE("an arm with fingers ends at the palm if the palm is named") {
  MechanismSpec spec = mechanism_of(*make_robot("panda"));
  const int palm = static_cast<int>(spec.bodies.size()) - 1;
  for (const double side : {1.0, -1.0}) {
    spec.bodies.push_back({.name = side > 0 ? "left" : "right",
                           .joint_name = side > 0 ? "left_slide" : "right_slide",
                           .parent = palm,
                           .joint = BodyJoint::kPrismatic,
                           .axis = side * Eigen::Vector3d::UnitY()});
  }
  spec.actuators.push_back({.name = "opening", .upper = 0.08});
  spec.coupling = Eigen::MatrixXd::Zero(9, 8);
  spec.coupling.topLeftCorner(7, 7).setIdentity();
  spec.coupling(7, 7) = spec.coupling(8, 7) = 0.5;
  spec.offset = Eigen::VectorXd::Zero(9);
  const Mechanism mechanism(spec);
  const std::string message = serial_arm(mechanism).error().message;
  CHECK(message.find("`left` (8 joints") != std::string::npos);
  CHECK(message.find("`right` (8 joints") != std::string::npos);
  CHECK(message.find("`tool` (7 joints") != std::string::npos);
  const Result<RobotSpec> arm = serial_arm(mechanism, "tool");
  REQUIRE(arm.ok());
  CHECK(arm->joints.size() == 7);
}
