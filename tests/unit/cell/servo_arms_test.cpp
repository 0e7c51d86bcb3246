#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>

#include "armlet/camera/visual_servo.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double kPeriod = 0.04;

ServoArm joints_of(const Robot& robot) {
  ServoArm arm{.lower = VectorXd(robot.n()),
               .upper = VectorXd(robot.n()),
               .max_speed = VectorXd(robot.n()),
               .max_accel = VectorXd(robot.n()),
               .turns = {}};
  for (int i = 0; i < robot.n(); ++i) {
    const Joint& joint = robot.joint(i);
    arm.lower[i] = joint.lower;
    arm.upper[i] = joint.upper;
    arm.max_speed[i] = joint.max_speed;
    arm.max_accel[i] = joint.max_accel;
    arm.turns.push_back(joint.is_revolute());
  }
  arm.rank = std::min(6, robot.n());
  return arm;
}

// An arm with an ideal camera 60 mm before its flange, which sees a square of 0.2 m.
struct EyeInHand {
  std::shared_ptr<const Robot> robot;
  Pinhole lens{intrinsics_from_focal(640, 480, 150.0)};
  Isometry3d T_tool_camera = Isometry3d(Eigen::Translation3d(0, 0, 0.06));
  MatrixXd corners = MatrixXd(4, 3);  // in the world

  // The square lies 0.5 m in front of the camera where the joints are at q_goal.
  EyeInHand(const std::string& name, const VectorXd& q_goal) : robot(make_robot(name)) {
    const Isometry3d T = forward(*robot, q_goal) * T_tool_camera;
    const double side[4][2] = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
    for (int i = 0; i < 4; ++i)
      corners.row(i) = (T * Vector3d(side[i][0], side[i][1], 0.5)).transpose();
  }
  [[nodiscard]] ServoSight sight(const VectorXd& q, const VectorXd& qd, double t) const {
    Jacobian J;
    const Isometry3d T_tool = forward_and_jacobian(*robot, q, J);
    const Isometry3d T = (T_tool * T_tool_camera).inverse();
    ServoSight out{.t = t,
                   .pixels = PlanePoints(4, 2),
                   .J_camera = camera_jacobian(J, T_tool.linear(), T_tool_camera),
                   .q = q,
                   .qd = qd,
                   .depths = VectorXd(4)};
    for (int i = 0; i < 4; ++i) {
      const Vector3d p = T * Vector3d(corners.row(i).transpose());
      out.pixels->row(i) = lens.project(p).value().transpose();
      out.depths[i] = p.z();
    }
    return out;
  }
};

}  // namespace

TEST_CASE("600 random starts of three arms converge in as many steps as the gain says") {
  const struct {
    const char* name;
    VectorXd q_goal;
  } arms[] = {{"puma560", VectorXd{{0.3, 0.9, 1.2, 0.4, 0.8, -0.2}}},
              {"pa10", VectorXd{{0.3, 0.5, 0.2, 0.9, -0.4, 0.6, 0.1}}},
              {"iiwa14", VectorXd{{0.2, 0.5, 0.1, -1.2, 0.3, 0.7, 0.2}}}};
  Random random(41);
  for (const auto& one : arms) {
    const std::string name = one.name;
    const VectorXd& q_goal = one.q_goal;
    const EyeInHand hand(name, q_goal);
    const ServoSight goal = hand.sight(q_goal, VectorXd::Zero(q_goal.size()), 0.0);
    for (int trial = 0; trial < 200; ++trial) {
      CAPTURE(name);
      CAPTURE(trial);
      const ServoOptions options{.law = static_cast<ServoLaw>(trial % 3),
                                 .gain = {1.0, 1.0, 1.0},
                                 .period = kPeriod,
                                 .within = 1e-3,
                                 .timeout = 60.0};
      VisualServo servo(hand.lens, {.wanted = *goal.pixels, .depths = goal.depths},
                        joints_of(*hand.robot), options);
      VectorXd q = q_goal, qd = VectorXd::Zero(q.size());
      for (Eigen::Index i = 0; i < q.size(); ++i) q[i] += random.uniform(-0.12, 0.12);
      for (int k = 0; servo.end() == ServoEnd::kNone; ++k) {
        qd = servo.look(hand.sight(q, qd, k * kPeriod));
        q += kPeriod * qd;
      }
      REQUIRE_MESSAGE(servo.end() == ServoEnd::kConverged, servo.why());
      const double steps = std::log(servo.rows().front().error / 1e-3) / -std::log(1 - kPeriod);
      CHECK(static_cast<double>(servo.rows().size()) == doctest::Approx(steps).epsilon(0.1));
    }
  }
}

TEST_CASE("a SCARA brings four of six directions of the picture to their goal") {
  const VectorXd q_goal{{0.5, -0.8, 0.1, 0.3}};
  const EyeInHand hand("scara", q_goal);
  const ServoSight goal = hand.sight(q_goal, VectorXd::Zero(4), 0.0);
  const ServoOptions options{
      .gain = {1.0, 1.0, 1.0}, .period = kPeriod, .within = 1e-3, .timeout = 60.0};
  Random random(43);
  for (int trial = 0; trial < 50; ++trial) {
    CAPTURE(trial);
    VisualServo servo(hand.lens, {.wanted = *goal.pixels, .depths = goal.depths},
                      joints_of(*hand.robot), options);
    VectorXd q = q_goal, qd = VectorXd::Zero(4);
    for (const int i : {0, 1, 3}) q[i] += random.uniform(-0.12, 0.12);
    q[2] += random.uniform(-0.05, 0.05);
    for (int k = 0; servo.end() == ServoEnd::kNone; ++k) {
      qd = servo.look(hand.sight(q, qd, k * kPeriod));
      q += kPeriod * qd;
    }
    REQUIRE_MESSAGE(servo.end() == ServoEnd::kConverged, servo.why());
    CHECK((q - q_goal).norm() < 1e-4);
    CHECK(servo.uncontrollable().cols() == 2);
    CHECK(servo.explanation().find("in 6 directions, this arm in 4 (rank of L J)") !=
          std::string::npos);
  }
}

TEST_CASE("a redundant arm stays away from the limits that it starts near") {
  VectorXd q_goal{{0.2, 0.5, 0.1, -1.2, 0.3, 0.7, 0.2}};
  const EyeInHand hand("iiwa14", q_goal);
  const ServoSight goal = hand.sight(q_goal, VectorXd::Zero(7), 0.0);
  ServoArm arm = joints_of(*hand.robot);
  arm.lower[2] = 0.08;  // the start is 0.01 rad before it, the goal 0.02 rad
  arm.upper[2] = 1.08;
  VisualServo servo(hand.lens, {.wanted = *goal.pixels, .depths = goal.depths}, arm,
                    {.gain = {1.0, 1.0, 1.0}, .period = kPeriod, .within = 1e-2, .timeout = 60.0});
  VectorXd q = q_goal, qd = VectorXd::Zero(7);
  q[2] = 0.09;
  q[0] += 0.08;
  double least = 1.0;
  for (int k = 0; servo.end() == ServoEnd::kNone; ++k) {
    qd = servo.look(hand.sight(q, qd, k * kPeriod));
    q += kPeriod * qd;
    least = std::min(least, q[2] - arm.lower[2]);
  }
  REQUIRE_MESSAGE(servo.end() == ServoEnd::kConverged, servo.why());
  CHECK(least > 0.009);
  CHECK(q[2] > 0.15);
}
