#include "armlet/model/robot.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

RobotSpec two_links() {
  RobotSpec spec;
  spec.name = "arm";
  spec.joints = joints_from_table({{0, 0, 1, 0}, {0, 0, 0.5, 0}}, "RR");
  spec.links.resize(2);
  return spec;
}

std::string message_of(const RobotSpec& spec) {
  try {
    Robot robot(spec);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "accepted";
}

// What another layer might keep with an arm: one value of its geometry, one of all of it.
struct Lengths {
  double sum = 0.0;
  explicit Lengths(const Chain& chain) {
    for (int i = 0; i <= chain.n; ++i) sum += chain.a[static_cast<std::size_t>(i)];
  }
};
struct Weight {
  double sum = 0.0;
  explicit Weight(const Robot& robot) {
    for (const Link& link : robot.spec().links) sum += link.mass;
  }
};

// The message after one thing is changed.
template <class Change>
std::string message_after(Change change) {
  RobotSpec spec = two_links();
  change(spec);
  return message_of(spec);
}

}  // namespace

TEST_CASE("an arm without joints or with too many is refused") {
  CHECK(message_of({}) == "Robot `robot` has no joints; expected 1 to 12.");
  CHECK(message_after([](RobotSpec& s) { s.joints.resize(13); }) ==
        "Robot `arm` has 13 joints; expected 1 to 12.");
  CHECK(message_after([](RobotSpec& s) { s.links.resize(3); }) ==
        "Robot `arm` has 3 links for 2 joints; expected one each.");
}

TEST_CASE("what is wrong with a joint is said with its number") {
  CHECK(message_after([](RobotSpec& s) { s.joints[1].dh.alpha = NAN; }) ==
        "Joint 2 of robot `arm` has alpha = nan; expected a finite number.");
  CHECK(message_after([](RobotSpec& s) {
          s.joints[0].lower = 1.0;
          s.joints[0].upper = -1.0;
        }) == "Joint 1 of robot `arm` has its limits swapped: 57.3 deg is above -57.3 deg.");
  CHECK(message_after([](RobotSpec& s) { s.joints[0].upper = INFINITY; }) ==
        "Joint 1 of robot `arm` has upper limit = inf; expected a finite number.");
  CHECK(message_after([](RobotSpec& s) { s.joints[1].max_speed = -1.0; }) ==
        "Joint 2 of robot `arm` has maxSpeed = -1; it must be above zero.");
  CHECK(message_after([](RobotSpec& s) { s.joints[1].max_effort = 0.0; }) ==
        "Joint 2 of robot `arm` has maxTorque = 0; it must be above zero.");
}

TEST_CASE("what is wrong with a link is said with its number") {
  CHECK(message_after([](RobotSpec& s) { s.links[0].mass = -2.0; }) ==
        "Link 1 of robot `arm` has mass = -2; it must be zero or more.");
  CHECK(message_after([](RobotSpec& s) { s.links[1].com.x() = NAN; }) ==
        "Link 2 of robot `arm` has a centre of mass or an inertia that is not finite.");
  CHECK(message_after([](RobotSpec& s) { s.links[1].inertia(0, 1) = 0.1; }) ==
        "Link 2 of robot `arm` has an inertia that is not symmetric: its element [1, 0] is 0 and "
        "[0, 1] "
        "is 0.1.");
  CHECK(message_after([](RobotSpec& s) {
          s.links[0].inertia = Eigen::Vector3d(1, -1, 1).asDiagonal();
        }) == "Link 1 of robot `arm` has an inertia with the negative principal moment -1 kg m^2.");
  const auto flat = [](RobotSpec& s) {
    s.links[0].inertia = Eigen::Vector3d(1, 2, 4).asDiagonal();
  };
  CHECK(message_after(flat) ==
        "Link 1 of robot `arm` has principal moments 1, 2, 4 kg m^2; in a rigid body none exceeds "
        "the sum of the other two.");
  CHECK(message_after([&](RobotSpec& s) {
          flat(s);
          s.inertia_check = InertiaCheck::kPublished;
        }) == "accepted");
  CHECK(message_after([](RobotSpec& s) { s.links[0].friction.coulomb_minus = 0.1; }) ==
        "Link 1 of robot `arm` has the Coulomb friction 0.1 for negative speed; it must be zero or "
        "less.");
}

TEST_CASE("base, tool, gravity and home are checked") {
  CHECK(message_after([](RobotSpec& s) { s.T_world_base.matrix()(0, 0) = 2; }).find("arm.base") !=
        std::string::npos);
  CHECK(message_after([](RobotSpec& s) {
          s.T_flange_tool.matrix()(0, 3) = NAN;
        }).find("arm.tool") != std::string::npos);
  CHECK(message_after([](RobotSpec& s) { s.gravity.z() = NAN; }).find("arm.gravity") !=
        std::string::npos);
  CHECK(message_after([](RobotSpec& s) { s.home = Eigen::VectorXd::Zero(3); }) ==
        "`arm.home` has 3 elements; expected 2.");
  CHECK(message_after([](RobotSpec& s) { s.home = Eigen::Vector2d(0, 7); }) ==
        "Joint 2 of robot `arm` is at 401.1 deg in the home position; its range is -360 deg to 360 "
        "deg.");
}

TEST_CASE("rates that are not given have the default values") {
  RobotSpec spec;
  spec.joints = joints_from_table({{0, 0, 1, 0}, {0, 0, 0, 0}}, "RP");
  spec.joints[1].max_speed = 0.2;
  const Robot robot(spec);
  CHECK(robot.max_speed()[0] == doctest::Approx(deg_to_rad(180)));
  CHECK(robot.max_accel()[0] == doctest::Approx(deg_to_rad(720)));
  CHECK(robot.max_jerk()[0] == doctest::Approx(deg_to_rad(7200)));
  CHECK(robot.max_speed()[1] == 0.2);
  CHECK(robot.max_accel()[1] == doctest::Approx(0.8));
  spec.joints = joints_from_table({{0, 0, 0, 0}}, "P");
  CHECK(Robot(spec).max_speed()[0] == 0.5);
}

TEST_CASE("a fraction of the acceleration leaves everything else") {
  const Robot robot(two_links());
  const Robot gentle = robot.with_acceleration(0.25);
  CHECK((gentle.max_accel() - 0.25 * robot.max_accel()).norm() == 0.0);
  CHECK(gentle.max_speed() == robot.max_speed());
  CHECK(gentle.max_jerk() == robot.max_jerk());
  CHECK_THROWS_AS((void)robot.with_acceleration(0.0), ArgumentError);
  CHECK_THROWS_AS((void)robot.with_acceleration(1.5), ArgumentError);
}

TEST_CASE("home is zero or the nearest value within the limits") {
  RobotSpec spec = two_links();
  spec.joints[1].lower = 0.5;
  const Robot robot(spec);
  CHECK(robot.home() == Eigen::VectorXd(Eigen::Vector2d(0.0, 0.5)));
}

TEST_CASE("no configuration within the limits reaches farther than reach()") {
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 200; ++k) {
      Eigen::VectorXd q = robot.lower();
      for (int i = 0; i < robot.n(); ++i) {
        const double share = ((k + 1) * (i + 3) * 7919 % 1000) / 999.0;
        q[i] += share * (robot.upper()[i] - robot.lower()[i]);
      }
      const Eigen::Vector3d p =
          forward(robot, q).translation() - robot.T_world_base().translation();
      CHECK(p.norm() <= robot.reach() + 1e-12);
    }
  }
}

TEST_CASE("copies with one thing changed keep the rest") {
  const Robot arm = *make_robot("scara");
  const Robot moved = arm.with_base(make_translation({0, -0.45, 0}));
  CHECK(moved.name() == "scara");
  const Eigen::Vector3d shift =
      forward(moved, arm.home()).translation() - forward(arm, arm.home()).translation();
  CHECK((shift - Eigen::Vector3d(0, -0.45, 0)).norm() < 1e-15);

  const Robot gripping = arm.with_tool(parallel_gripper(0.08));
  const Eigen::Vector3d below =
      forward(gripping, arm.home()).translation() - forward(arm, arm.home()).translation();
  CHECK((below - Eigen::Vector3d(0, 0, -0.12)).norm() < 1e-15);
  CHECK(gripping.tool().stroke == 0.08);
  CHECK(gripping.with_tool_point(Eigen::Isometry3d::Identity()).tool().stroke == 0.08);
  CHECK(arm.with_name("left").name() == "left");
  CHECK(arm.with_home(Eigen::VectorXd::Zero(4)).home().isZero());
}

TEST_CASE("limits are changed for all joints, and home moves inside") {
  const Robot arm(two_links());
  const Robot narrow = arm.with_limits(Eigen::Vector2d(-1.0, 0.25), Eigen::Vector2d(1.0, 2.0));
  CHECK(narrow.lower() == Eigen::VectorXd(Eigen::Vector2d(-1.0, 0.25)));
  CHECK(narrow.upper() == Eigen::VectorXd(Eigen::Vector2d(1.0, 2.0)));
  CHECK(narrow.home() == Eigen::VectorXd(Eigen::Vector2d(0.0, 0.25)));
  CHECK(narrow.max_accel() == arm.max_accel());
  CHECK_THROWS_WITH_AS(
      (void)arm.with_limits(Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 1)),
      "Joint 1 of robot `arm` has its limits swapped: 57.3 deg is above -57.3 deg.", ArgumentError);
  CHECK_THROWS_WITH_AS((void)arm.with_limits(Eigen::Vector3d::Zero(), Eigen::Vector2d(1, 1)),
                       "`lower` has 3 elements; expected 2.", ArgumentError);
  CHECK_THROWS_AS((void)arm.with_limits(Eigen::Vector2d(NAN, 0), Eigen::Vector2d(1, 1)),
                  ArgumentError);
}

TEST_CASE("an arm keeps values of several types, and its copies share them") {
  RobotSpec spec = two_links();
  spec.links[0].mass = 2.0;
  spec.links[1].mass = 0.5;
  const Robot arm(spec);
  CHECK(arm.derived<Weight>().sum == 2.5);
  CHECK(arm.derived<Lengths>().sum == 1.5);
  const Robot copy = arm;
  CHECK(&copy.derived<Weight>() == &arm.derived<Weight>());
  CHECK(&copy.derived<Lengths>() == &arm.derived<Lengths>());
  Robot assigned = *make_robot("scara");
  assigned = arm;
  CHECK(&assigned.derived<Weight>() == &arm.derived<Weight>());
  CHECK(&assigned.derived<Lengths>() == &arm.derived<Lengths>());
}

TEST_CASE("a value of the geometry is shared by all copies with the same geometry, and no others") {
  const Robot arm(two_links());
  const Lengths& lengths = arm.derived<Lengths>();
  const Weight& weight = arm.derived<Weight>();
  const Eigen::Vector2d one = Eigen::Vector2d::Ones();
  for (const Robot& copy :
       {arm.with_name("other"), arm.with_home(0.5 * one), arm.with_acceleration(0.5),
        arm.with_limits(-one, one), arm.with_limits(-one, one).with_acceleration(0.5),
        arm.with_base(arm.T_world_base()), arm.with_tool_point(arm.T_flange_tool())}) {
    CHECK(&copy.derived<Lengths>() == &lengths);
    CHECK(&copy.derived<Weight>() != &weight);  // made of all of the robot
  }
  for (const Robot& copy : {arm.with_base(make_translation({0, 0, 1e-9})),
                            arm.with_tool_point(make_translation({0, 1e-9, 0})),
                            arm.with_tool_point(make_translation({0, 0, -0.0})),
                            arm.with_tool(parallel_gripper(0.08))}) {
    CHECK(&copy.derived<Lengths>() != &lengths);
  }
  CHECK(&Robot(arm.spec()).derived<Lengths>() != &lengths);  // not a copy
}

TEST_CASE("a table that does not fit its joint kinds is explained") {
  CHECK_THROWS_WITH_AS(joints_from_table({{0, 0, 1}}, "R"),
                       "Row 1 of the table has 3 numbers; expected 4: theta, d, a, alpha.",
                       ArgumentError);
  CHECK_THROWS_WITH_AS(
      joints_from_table({{0, 0, 1, 0}}, "X"),
      "Joint 1 has the kind 'X'; expected R for a turning joint or P for a sliding one.",
      ArgumentError);
  CHECK_THROWS_WITH_AS(joints_from_table({{0, 0, 1, 0}}, "RR"),
                       "The table has 1 rows, but the joint kinds \"RR\" name 2 joints; expected "
                       "one letter R or P per row.",
                       ArgumentError);
}
