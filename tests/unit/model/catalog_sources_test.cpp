// The arms of the catalogue that the reference files do not hold, against the frames that their
// makers and their users publish, which are written otherwise than DH rows.

#include <doctest/doctest.h>

#include <array>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

// A joint as in a robot description: where it is in the frame before it, and its axis.
struct Origin {
  Eigen::Vector3d xyz, rpy, axis;
};
constexpr double kHalf = kPi / 2;

Eigen::Isometry3d product(const std::vector<Origin>& origins, const Eigen::VectorXd& q,
                          const Eigen::Isometry3d& T_last_tool) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < origins.size(); ++i) {
    T = T * make_pose(R_from_rpy(origins[i].rpy), origins[i].xyz) *
        make_pose(R_from_axis_angle(origins[i].axis, q[static_cast<Eigen::Index>(i)]),
                  Eigen::Vector3d::Zero());
  }
  return T * T_last_tool;
}

void check_against(const Robot& robot, const std::vector<Origin>& origins,
                   const Eigen::Isometry3d& T_last_tool) {
  CAPTURE(robot.name());
  REQUIRE(robot.n() == static_cast<int>(origins.size()));
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    Eigen::VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    CHECK((forward(robot, q).matrix() - product(origins, q, T_last_tool).matrix())
              .cwiseAbs()
              .maxCoeff() < 1e-10);
  }
}

// ur_description/config/*/default_kinematics.yaml of ROS-Industrial, its angles without rounding.
std::vector<Origin> ur_origins(double d1, double a2, double a3, double d4, double d5, double d6) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  return {{{0, 0, d1}, {0, 0, 0}, z},      {{0, 0, 0}, {kHalf, 0, 0}, z},
          {{a2, 0, 0}, {0, 0, 0}, z},      {{a3, 0, d4}, {0, 0, 0}, z},
          {{0, -d5, 0}, {kHalf, 0, 0}, z}, {{0, d6, 0}, {kHalf, kPi, kPi}, z}};
}

}  // namespace

TEST_CASE("UR3, UR5 and UR10 are the arms of the ROS-Industrial descriptions") {
  const Eigen::Isometry3d none = Eigen::Isometry3d::Identity();
  check_against(*make_robot("ur3"), ur_origins(.1519, -.24365, -.21325, .11235, .08535, .0819),
                none);
  check_against(*make_robot("ur5"), ur_origins(.089159, -.425, -.39225, .10915, .09465, .0823),
                none);
  check_against(*make_robot("ur10"), ur_origins(.1273, -.612, -.5723, .163941, .1157, .0922), none);
}

TEST_CASE("the LBR iiwa is the arm of iiwa_stack") {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  check_against(*make_robot("iiwa14"),
                {{{0, 0, .1575}, {0, 0, 0}, z},
                 {{0, 0, .2025}, {kHalf, 0, kPi}, z},
                 {{0, .2045, 0}, {kHalf, 0, kPi}, z},
                 {{0, 0, .2155}, {kHalf, 0, 0}, z},
                 {{0, .1845, 0}, {-kHalf, kPi, 0}, z},
                 {{0, 0, .2155}, {kHalf, 0, 0}, z},
                 {{0, .081, 0}, {-kHalf, kPi, 0}, z}},
                make_translation({0, 0, .045}));
}

TEST_CASE("the IRB 120 is the arm of the ROS-Industrial description, its tool frame included") {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ(), o = Eigen::Vector3d::Zero();
  check_against(*make_robot("irb120"),
                {{{0, 0, 0}, o, z},
                 {{0, 0, .29}, o, y},
                 {{0, 0, .27}, o, y},
                 {{0, 0, .07}, o, x},
                 {{.302, 0, 0}, o, y},
                 {{.072, 0, 0}, o, x}},
                make_pose(rot_y(kHalf), Eigen::Vector3d::Zero()));
}

// kuka_kr6_support/urdf/kr6r900sixx_macro.xacro of ROS-Industrial; its joints 1, 4 and 6 are
// positive to the other side.
TEST_CASE("the KR 6 R900 is the arm of the ROS-Industrial description, its flange included") {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ(), o = Eigen::Vector3d::Zero();
  check_against(*make_robot("kr6"),
                {{{0, 0, .4}, o, z},
                 {{.025, 0, 0}, o, y},
                 {{.455, 0, 0}, o, y},
                 {{0, 0, .035}, o, x},
                 {{.42, 0, 0}, o, y},
                 {{.08, 0, 0}, o, x}},
                make_pose(rot_y(kHalf), Eigen::Vector3d::Zero()));
}

// With the arm in one plane, as in the drawing of the data sheet: 400 mm up, 25 mm out, the upper
// arm of 455 mm, 35 mm across and 420 + 80 mm along the forearm.
TEST_CASE("the KR 6 R900 reaches where its data sheet draws it") {
  const Robot robot = *make_robot("kr6");
  const auto flange = [&](double a2, double a3, double a5) {
    Eigen::VectorXd q(6);
    q << 0, deg_to_rad(a2), deg_to_rad(a3), 0, deg_to_rad(a5), 0;
    return Eigen::Vector3d(forward(robot, q).translation());
  };
  CHECK((flange(0, 0, 0) - Eigen::Vector3d(.025 + .455 + .42 + .08, 0, .435)).norm() < 1e-12);
  CHECK((flange(-90, 90, 0) - Eigen::Vector3d(.025 + .42 + .08, 0, .89)).norm() < 1e-12);
  CHECK((flange(-90, 90, 90) - Eigen::Vector3d(.025 + .42, 0, .81)).norm() < 1e-12);
  CHECK((flange(-90, 0, 0) - Eigen::Vector3d(.025 - .035, 0, .4 + .455 + .5)).norm() < 1e-12);
  // Its reach of 901.5 mm is that of the wrist centre, 80 mm before the flange, with upper arm and
  // forearm in one line.
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  q[2] = std::atan2(.035, .42);
  const Eigen::Vector3d wrist = forward(robot, q) * Eigen::Vector3d(0, 0, -.08);
  CHECK(std::abs(wrist.x() - .9015) < .5e-4);
}

TEST_CASE("planar arms and the elbow arm are where plane geometry puts them") {
  Random random(4);
  const Robot planar = *make_robot("planar3"), elbow = *make_robot("anthropomorphic");
  for (int k = 0; k < 1000; ++k) {
    const double a = random.uniform(-3, 3), b = random.uniform(-2, 2), c = random.uniform(-2, 2);
    const Eigen::Vector3d q(a, b, c);
    const auto arm = [](double length, double angle) {
      return Eigen::Vector2d(length * std::cos(angle), length * std::sin(angle));
    };
    const Eigen::Vector3d p = forward(planar, q).translation();
    CHECK((p.head<2>() - arm(.4, a) - arm(.3, a + b) - arm(.2, a + b + c)).norm() < 1e-12);
    const Eigen::Vector2d upright = arm(.45, b) + arm(.35, b + c);
    const Eigen::Vector3d expected(upright.x() * std::cos(a), upright.x() * std::sin(a),
                                   .4 + upright.y());
    CHECK((forward(elbow, q).translation() - expected).norm() < 1e-12);
  }
}

TEST_CASE("the arm of seven joints hangs its wrist between a shoulder and an elbow") {
  const Robot arm = *make_robot("arm7");
  Random random(5);
  for (int k = 0; k < 1000; ++k) {
    Eigen::VectorXd q(7);
    for (int i = 0; i < 7; ++i) q[i] = random.uniform(arm.lower()[i], arm.upper()[i]);
    const Eigen::Isometry3d T = forward(arm, q);
    const Eigen::Vector3d wrist = T * Eigen::Vector3d(0, 0, -.126), shoulder(0, 0, .34);
    const double squared = .4 * .4 * 2 * (1 + std::cos(q[3]));
    CHECK(std::abs((wrist - shoulder).squaredNorm() - squared) < 1e-12);
  }
}
