#include "armlet/model/joint_coupling.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

// A lift of three stages: the second copies the first, the third is half as fast and 10 mm out.
RobotSpec lift() {
  RobotSpec spec{.name = "lift"};
  Joint slide{.kind = JointKind::kPrismatic, .lower = 0.0, .upper = 0.4, .max_speed = 0.2};
  spec.joints = {slide, slide, slide};
  spec.joints[1].drive = {.of = 0};
  spec.joints[2].drive = {.of = 0, .ratio = 0.5, .offset = 0.01};
  return spec;
}

std::string refused(const RobotSpec& spec) {
  try {
    const Robot robot(spec);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

// A column whose second stage copies the first, and an arm whose wrist copies its elbow in the
// opposite direction.
constexpr const char* kColumn = R"(<robot name="column">
  <link name="base"/>
  <joint name="stage1" type="prismatic"><parent link="base"/><child link="a"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="0.5" effort="300" velocity="0.4"/>
    <dynamics damping="2" friction="3"/></joint>
  <link name="a"/>
  <joint name="stage2" type="prismatic"><parent link="a"/><child link="b"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="0.3" effort="1" velocity="0.1"/>
    <dynamics damping="4" friction="5"/><mimic joint="stage1" multiplier="0.5" offset="0.02"/></joint>
  <link name="b"/>
  <joint name="elbow" type="revolute"><parent link="b"/><child link="c"/>
    <origin xyz="0.1 0 0"/><axis xyz="0 1 0"/><limit lower="-2" upper="2.5" effort="40" velocity="3"/></joint>
  <link name="c"/>
  <joint name="wrist" type="revolute"><parent link="c"/><child link="d"/>
    <origin xyz="0.3 0 0"/><axis xyz="0 1 0"/><limit lower="-1.5" upper="1.5" effort="40" velocity="6"/>
    <mimic joint="elbow" multiplier="-1"/></joint>
  <link name="d"/>
</robot>)";

Robot arm_of(const std::string& text) {
  const Result<RobotSpec> spec = serial_arm_of_urdf(text, {});
  REQUIRE(spec.ok());
  return Robot(*spec);
}

}  // namespace

TEST_CASE("a robot whose rows copy others has one value for each joint") {
  const Robot robot(lift());
  REQUIRE(robot.n() == 1);
  REQUIRE(robot.rows() == 3);
  CHECK(robot.home().size() == 1);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.2);
  CHECK(row_values(robot, q).isApprox(Eigen::Vector3d(0.2, 0.2, 0.11), 1e-15));
  CHECK(row_rates(robot, q).isApprox(Eigen::Vector3d(0.2, 0.2, 0.1), 1e-15));
  CHECK(joint_forces(robot, Eigen::Vector3d(1.0, 2.0, 4.0))[0] == 5.0);
  CHECK(forward(robot, q).translation().z() == doctest::Approx(0.51).epsilon(1e-14));
  CHECK(link_frames(robot, q).size() == 3);
  // A row moves as far as its joint lets it.
  CHECK(robot.row(2).lower == 0.01);
  CHECK(robot.row(2).upper == doctest::Approx(0.21));
  CHECK(robot.row(2).max_speed == 0.1);
  CHECK(copy_text(robot, 0).empty());
  CHECK(copy_text(robot, 1) == "1 x joint 1");
  CHECK(copy_text(robot, 2) == "0.5 x joint 1 + 10 mm");
}

TEST_CASE("copies of a robot with coupled rows are coupled alike") {
  const Robot robot(lift());
  const Robot low = robot.with_limits(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.1));
  CHECK(low.row(1).upper == 0.1);
  CHECK(low.row(2).upper == doctest::Approx(0.06));
  CHECK(robot.with_acceleration(0.5).row(2).max_accel == 0.25 * robot.row(1).max_accel);
  Link link;
  link.mass = 3.0;
  CHECK(robot.with_link(2, link).uncoupled().link(2).mass == 3.0);
  CHECK(robot.with_home(Eigen::VectorXd::Constant(1, 0.3)).uncoupled().home()[2] ==
        doctest::Approx(0.16));
  link.friction.viscous = 1.0;
  CHECK(refusal_of([&] { (void)robot.with_link(2, link); }) ==
        "Row 3 of robot `lift` copies row 1, which has the motor; give that one the rotor inertia "
        "and the friction.");
}

TEST_CASE("drives that lead nowhere are refused") {
  RobotSpec spec = lift();
  spec.joints[2].drive.of = 1;
  CHECK(refused(spec) ==
        "Row 3 of robot `lift` copies row 2; expected one with a joint of its own.");
  spec = lift();
  spec.joints[1].drive.of = 3;
  CHECK(refused(spec).find("copies row 4") != std::string::npos);
  spec = lift();
  spec.joints[1].drive.ratio = 0.0;
  CHECK(refused(spec).find("the first not zero") != std::string::npos);
}

TEST_CASE("rows that all have joints of their own are no coupling") {
  RobotSpec spec = lift();
  for (Joint& row : spec.joints) row.drive = {};
  const Robot robot(spec);
  CHECK(robot.n() == 3);
  CHECK(robot.coupling() == nullptr);
  CHECK(&robot.uncoupled() == &robot);
}

TEST_CASE("limits of a joint that copies restrict the joint that it copies") {
  const Robot robot = arm_of(kColumn);
  REQUIRE(robot.n() == 2);
  REQUIRE(robot.rows() == 4);
  REQUIRE(robot.spec().notes.size() == 1);
  CHECK(robot.spec().notes[0] ==
        "the limits of joint `wrist` keep joint `elbow`, which it copies, between -85.9 deg and "
        "85.9 deg");
  CHECK(robot.lower()[0] == 0.0);
  CHECK(robot.upper()[0] == 0.5);  // 0.3 of stage 2 would be 0.56
  CHECK(robot.max_speed()[0] == doctest::Approx(0.2));
  CHECK(robot.lower()[1] == doctest::Approx(-1.5));
  CHECK(robot.upper()[1] == doctest::Approx(1.5));
  CHECK(robot.max_speed()[1] == 3.0);
  CHECK(robot.row_of(1) == 2);
  CHECK(copy_text(robot, 3) == "-1 x joint 2");
}

TEST_CASE("limits that leave no range do not count, and a note says so") {
  const Result<RobotSpec> spec = serial_arm_of_urdf(
      replaced(kColumn, R"(lower="-1.5" upper="1.5")", R"(lower="3" upper="4")"), {});
  REQUIRE(spec.ok());
  REQUIRE(spec->notes.size() == 1);
  CHECK(spec->notes[0] ==
        "the limits of joint `wrist` leave joint `elbow`, which it copies, no range; they do not "
        "count");
  CHECK(Robot(*spec).lower()[1] == -2.0);
}

TEST_CASE("limits of a whole revolution, or none, restrict no joint that is copied") {
  for (const char* limits : {R"(lower="0" upper="6.283")", R"(lower="0" upper="0")"}) {
    const Result<RobotSpec> spec =
        serial_arm_of_urdf(replaced(kColumn, R"(lower="-1.5" upper="1.5")", limits), {});
    REQUIRE(spec.ok());
    CHECK(spec->notes.empty());
    CHECK(Robot(*spec).upper()[1] == 2.5);
  }
}

TEST_CASE("friction of a joint that copies acts on the motor of the joint that it copies") {
  const Robot robot = arm_of(kColumn);
  const Friction& friction = robot.motor_link(0).friction;
  CHECK(friction.viscous == doctest::Approx(2.0 + 0.25 * 4.0));
  CHECK(friction.coulomb_plus == doctest::Approx(3.0 + 0.5 * 5.0));
  CHECK(friction.coulomb_minus == doctest::Approx(-3.0 - 0.5 * 5.0));
  CHECK(robot.link(1).friction.viscous == 0.0);
}

TEST_CASE("a description that is written and read again has the same coupling") {
  const Robot robot = arm_of(kColumn);
  const std::string text = write_urdf(Mechanism(mechanism_of(robot)));
  CHECK(text.find(R"(<mimic joint="joint1" multiplier="0.5" offset="0.02"/>)") !=
        std::string::npos);
  CHECK(text.find(R"(<mimic joint="joint3" multiplier="-1" offset="0"/>)") != std::string::npos);
  const Robot again = arm_of(text);
  REQUIRE(again.n() == 2);
  CHECK(again.lower().isApprox(robot.lower(), 1e-12));
  CHECK(again.upper().isApprox(robot.upper(), 1e-12));
  for (const double a : {0.0, 0.2, 0.45}) {
    const Eigen::Vector2d q(a, 3.0 * a - 0.6);
    CHECK((forward(again, q).matrix() - forward(robot, q).matrix()).norm() < 1e-12);
  }
}

TEST_CASE("a description that is written again keeps the limits of joints that copy") {
  const Result<Mechanism> read = read_urdf(kColumn);
  REQUIRE(read.ok());
  const Robot robot = arm_of(kColumn), again = arm_of(write_urdf(*read));
  CHECK(again.lower().isApprox(robot.lower(), 1e-12));
  CHECK(again.upper().isApprox(robot.upper(), 1e-12));
  CHECK(again.max_speed().isApprox(robot.max_speed(), 1e-12));
}

TEST_CASE("a chain whose leader is beside it moves by its own joint") {
  // The elbow copies a joint of another branch, by -2 and 0.3 rad.
  const std::string text = replaced(
      replaced(kColumn, R"(effort="40" velocity="3"/>)",
               R"(effort="40" velocity="3"/><mimic joint="side" multiplier="-2" offset="0.3"/>)"),
      "</robot>", R"(<joint name="side" type="revolute"><parent link="base"/>
    <child link="e"/><axis xyz="0 1 0"/><limit lower="-0.5" upper="1" effort="80" velocity="1"/></joint>
    <link name="e"/></robot>)");
  const Result<RobotSpec> spec = serial_arm_of_urdf(text, {}, "d");
  REQUIRE(spec.ok());
  const Robot robot(*spec);
  REQUIRE(robot.n() == 2);
  CHECK(robot.lower()[1] == doctest::Approx(-1.5));  // of the wrist, which is reversed
  CHECK(robot.upper()[1] == doctest::Approx(1.3));
  CHECK(robot.max_speed()[1] == doctest::Approx(2.0));
  CHECK(robot.joint(1).max_effort == doctest::Approx(40.0));
  CHECK(copy_text(robot, 3) == "-1 x joint 2");
}

TEST_CASE("a joint that several motors move, or none, belongs to no arm") {
  const Result<RobotSpec> still = serial_arm_of_urdf(
      replaced(kColumn, R"(multiplier="-1")", R"(multiplier="0" offset="0.2")"), {});
  REQUIRE_FALSE(still.ok());
  CHECK(still.error().message ==
        "joint `wrist` of `column` moves with no other joint and has no motor, so it cannot belong "
        "to an arm; make it fixed, or end the arm before it with tip: \"c\"");
  const Result<Mechanism> read = read_urdf(kColumn);
  REQUIRE(read.ok());
  MechanismSpec spec = read->spec();
  spec.coupling(3, 0) = 0.5;
  const Result<RobotSpec> differential = serial_arm(Mechanism(spec));
  REQUIRE_FALSE(differential.ok());
  CHECK(differential.error().message ==
        "joint `wrist` of `column` moves with `stage1` and `elbow` together, and a joint of an arm "
        "copies one joint; tip: \"c\" ends the arm before it");
}
