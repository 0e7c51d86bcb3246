#include "armlet/model/urdf.hpp"

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/model/serial_arm.hpp"
#include "random_arm.hpp"
#include "reference_robot.hpp"
#include "same_arm.hpp"

using namespace armlet;

namespace {

// Two links and a gripper whose second finger copies the first; angles rounded as people write
// them.
constexpr const char* kArm = R"(<?xml version="1.0"?>
<robot name="small">
  <link name="floor"/>
  <joint name="stand" type="fixed"><parent link="floor"/><child link="base"/>
    <origin xyz="0 0 0.5" rpy="0 0 0"/></joint>
  <link name="base"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.1" rpy="1.5708 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2.5" effort="40" velocity="3"/>
    <dynamics damping="0.2" friction="0.1"/></joint>
  <link name="upper"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/></inertial></link>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.4 0 0" rpy="0 0 0"/><axis xyz="0 0 2"/></joint>
  <link name="fore"/>
  <joint name="left" type="prismatic"><parent link="fore"/><child link="left_finger"/>
    <origin xyz="0.3 0 0"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="0" velocity="0"/></joint>
  <link name="left_finger"/>
  <joint name="right" type="prismatic"><parent link="fore"/><child link="right_finger"/>
    <origin xyz="0.3 0 0"/><axis xyz="0 -1 0"/><limit lower="0" upper="0.04" effort="0" velocity="0"/>
    <mimic joint="left" multiplier="0.5" offset="0.01"/></joint>
  <link name="right_finger"/>
</robot>)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  const Result<Mechanism> read = read_urdf(text);
  return read.ok() ? "accepted" : read.error().message;
}
std::string refusal(const std::string& from, const std::string& to) {
  return refusal(replaced(kArm, from, to));
}

double difference(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("a description is read with its limits, masses, friction, fixed and mimic joints") {
  const Result<Mechanism> read = read_urdf(kArm);
  REQUIRE(read.ok());
  const Mechanism& m = *read;
  CHECK(m.name() == "small");
  CHECK(m.spec().base_name == "floor");
  CHECK(m.bodies().size() == 5);
  CHECK(m.joint_count() == 4);
  REQUIRE(m.actuator_count() == 3);
  CHECK(m.actuators()[0].upper == 2.5);
  CHECK(m.actuators()[0].max_effort == 40);
  CHECK(m.actuators()[1].upper == kNoLimit);
  const Body& upper = m.bodies()[static_cast<std::size_t>(m.body("upper"))];
  CHECK(upper.link.mass == 2);
  CHECK(upper.link.com.x() == 0.2);
  CHECK(upper.link.friction.viscous == 0.2);
  CHECK(upper.link.friction.coulomb_minus == -0.1);
  const Eigen::VectorXd joints = m.joint_values(Eigen::Vector3d(0, 0, 0.03));
  CHECK(joints[2] == 0.03);
  CHECK(joints[3] == doctest::Approx(0.025));
}

TEST_CASE("a rounded right angle is a right angle") {
  const Result<Mechanism> read = read_urdf(kArm);
  REQUIRE(read.ok());
  const Eigen::VectorXd q = Eigen::Vector3d(kPi / 2, 0, 0);
  const auto frames = body_frames(*read, q);
  const Eigen::Vector3d p = frames[static_cast<std::size_t>(read->body("fore"))].translation();
  CHECK((p - Eigen::Vector3d(0, 0, 1.0)).norm() < 1e-15);
}

TEST_CASE("an arm whose fingers divide says where it can end, and ends at its palm by name") {
  const Result<RobotSpec> open = serial_arm(*read_urdf(kArm));
  REQUIRE_FALSE(open.ok());
  CHECK(open.error().message ==
        "`small` has several arms: they divide at the link `fore` and end at `left_finger` (3 "
        "joints: shoulder, elbow, left), `right_finger` (3 joints: shoulder, elbow, right), `fore` "
        "(2 joints: shoulder, elbow), where they meet; name the link at the end of the arm, tip: "
        "\"left_finger\" in a program, --tip left_finger in the command");
  const Result<RobotSpec> spec = serial_arm(*read_urdf(kArm), "fore");
  REQUIRE(spec.ok());
  const Robot robot(*spec);
  CHECK(robot.n() == 2);
  CHECK((forward(robot, Eigen::Vector2d::Zero()).translation() - Eigen::Vector3d(0.4, 0, 0.6))
            .norm() < 1e-14);
}

TEST_CASE("the base of an arm is the root link, and the origin of its first joint stays") {
  const Robot robot(*serial_arm(*read_urdf(kArm), "fore"));
  const Eigen::Vector2d q(0.3, -0.4);
  const Eigen::Isometry3d T_world_root = pose_from_rpy({1, 2, 3}, {0.1, 0.2, 0.3});
  const Robot moved = robot.with_base(T_world_root);
  CHECK(difference(link_frame(robot, q, 0), Eigen::Isometry3d::Identity()) == 0.0);
  CHECK(difference(link_frame(moved, q, 0), T_world_root) == 0.0);
  CHECK(difference(forward(moved, q), T_world_root * forward(robot, q)) < 1e-14);
  CHECK(robot.joint(1).is_continuous());
  CHECK_FALSE(robot.joint(0).is_continuous());
}

TEST_CASE("a description that is written says what it loses, and keeps joints without limits") {
  MechanismSpec spec = read_urdf(kArm)->spec();
  Link& upper = spec.bodies[1].link;
  REQUIRE(spec.bodies[1].name == "upper");
  CHECK(write_urdf(Mechanism(spec)).find("not in a URDF") == std::string::npos);
  upper.motor_inertia = 0.002;
  upper.gear = 10.0;
  upper.friction.coulomb_minus = 0.0;
  const std::string text = write_urdf(Mechanism(spec));
  CHECK(text.find("the rotor's inertia, 0.2 kg m^2 at the joint") != std::string::npos);
  CHECK(text.find("in the two directions") != std::string::npos);
  const Result<Mechanism> again = read_urdf(text);
  REQUIRE(again.ok());
  CHECK(is_no_limit(again->actuators()[1].lower, again->actuators()[1].upper));
}

TEST_CASE("every arm of the catalogue comes back from its description with the same tool pose") {
  Random random(41);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const std::string text = write_urdf(Mechanism(mechanism_of(robot)));
    const Result<Mechanism> read = read_urdf(text, {.inertia_check = robot.spec().inertia_check});
    REQUIRE(read.ok());
    const Result<RobotSpec> spec = serial_arm(*read);
    REQUIRE(spec.ok());
    const Robot again(*spec);
    check_same_joints(again, robot);
    double mass = 0.0, mass_again = 0.0;
    for (int i = 0; i < robot.n(); ++i) {
      mass += robot.link(i).mass;
      mass_again += again.link(i).mass;
      CHECK(again.joint(i).max_effort == robot.joint(i).max_effort);
    }
    CHECK(mass == doctest::Approx(mass_again).epsilon(1e-12));
    for (int k = 0; k < 200; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      CHECK(difference(forward(again, q), forward(robot, q)) < 1e-12);
    }
  }
}

TEST_CASE("arms of mixed conventions and joints come back too") {
  Random random(42);
  for (const std::string& name : reference::arm_names()) {
    CAPTURE(name);
    const Robot robot = reference::robot_of(reference::load(name).at("robot"));
    const auto read = read_urdf(write_urdf(Mechanism(mechanism_of(robot))),
                                {.inertia_check = InertiaCheck::kPublished});
    REQUIRE(read.ok());
    const Robot again(*serial_arm(*read));
    for (int k = 0; k < 100; ++k) {
      Eigen::VectorXd q(robot.n());
      for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
      CHECK(difference(forward(again, q), forward(robot, q)) < 1e-12);
    }
  }
}

TEST_CASE("a joint that copies another by a factor of 0 keeps its pose in a written description") {
  const Result<Mechanism> read = read_urdf(
      replaced(kArm, R"(multiplier="0.5" offset="0.01")", R"(multiplier="0" offset="0.02")"));
  REQUIRE(read.ok());
  const Result<Mechanism> again = read_urdf(write_urdf(*read));
  REQUIRE(again.ok());
  REQUIRE(again->actuator_count() == read->actuator_count());
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(read->actuator_count(), 0.005);
  CHECK(again->joint_values(q) == read->joint_values(q));
}

TEST_CASE("a hand with fingers comes back with its coupling") {
  Random random(43);
  for (const Mechanism& hand : {make_barrett_hand(), make_parallel_gripper()}) {
    CAPTURE(hand.name());
    const Result<Mechanism> read = read_urdf(write_urdf(hand));
    REQUIRE(read.ok());
    REQUIRE(read->actuator_count() == hand.actuator_count());
    for (int k = 0; k < 50; ++k) {
      Eigen::VectorXd q(hand.actuator_count()), q_read(hand.actuator_count());
      // The description's actuators are the joints that lead.
      for (int a = 0; a < hand.actuator_count(); ++a)
        q[a] = random.uniform(0, hand.actuators()[static_cast<std::size_t>(a)].upper);
      const Eigen::VectorXd joints = hand.joint_values(q);
      for (int a = 0; a < read->actuator_count(); ++a) {
        for (int j = 0; j < hand.joint_count(); ++j) {
          const Body& body =
              hand.bodies()[static_cast<std::size_t>(hand.moving()[static_cast<std::size_t>(j)])];
          if (body.joint_name == read->actuators()[static_cast<std::size_t>(a)].name)
            q_read[a] = joints[j];
        }
      }
      const auto frames = body_frames(*read, q_read);
      for (const Tip& tip : hand.tips()) {
        CHECK(difference(frames[static_cast<std::size_t>(read->body(tip.name))],
                         tip_pose(hand, q, tip)) < 1e-12);
      }
    }
  }
}

TEST_CASE("a broken description is refused with the name of what is broken") {
  CHECK(refusal(R"(<parent link="upper"/><child link="fore"/>)",
                R"(<parent link="fore"/><child link="fore"/>)") ==
        "link `fore` is its own parent (joint `elbow`)");
  CHECK(
      refusal(
          "</robot>",
          R"(<joint name="tie" type="fixed"><parent link="fore"/><child link="left_finger"/></joint></robot>)") ==
      "link `left_finger` hangs on two joints, `left` and `tie`; every link has one parent");
  const std::string circle =
      "the links `fore`, `left_finger` hang on one another in a circle; one link carries all "
      "others and hangs on none";
  CHECK(refusal(R"(<parent link="upper"/><child link="fore"/>)",
                R"(<parent link="left_finger"/><child link="fore"/>)") == circle);
  CHECK(refusal("<link name=\"base\"/>",
                R"(<link name="a > b"/><!-- <joint><parent link="x"/><child link="x"/></joint> -->
                <joint name="j1"><parent link="a > b"/><child link="b"/></joint>
                <joint name="j2"><parent link="b"/><child link="a > b"/></joint>
                <joint name="j0"><parent link="b"/><child link="c"/></joint>)")
            .starts_with("the links `b`, `a > b` hang on one another in a circle;"));
  CHECK(refusal(R"(lower="-2" upper="2.5")", R"(lower="2.5" upper="-2")") ==
        "Actuator `shoulder` of `small` has its limits swapped: 2.5 is above -2.");
  CHECK(refusal(R"(axis xyz="0 0 2")", R"(axis xyz="0 0 0")").find("Link `fore`") == 0);
  CHECK(refusal(R"(mimic joint="left")", R"(mimic joint="middle")") ==
        "joint `right` copies `middle`, which does not exist");
  CHECK(refusal(R"(mimic joint="left")", R"(mimic joint="right")") ==
        "joint `right` copies itself through other joints");
  CHECK(refusal(R"(mimic joint="left")", R"(mimic joint="stand")") ==
        "joint `right` copies `stand`, which is fixed");
  CHECK(refusal(R"(name="elbow" type="continuous")", R"(name="elbow" type="floating")")
            .find("joint `elbow`") == 0);
  CHECK(refusal(R"(type="continuous")", R"(type="bendy")").find("elbow") != std::string::npos);
  CHECK(refusal(R"(<child link="fore"/>)", R"(<child link="elsewhere"/>)").find("elsewhere") !=
        std::string::npos);
  CHECK(refusal(R"(<link name="fore"/>)", R"(<link name="upper"/>)").find("upper") !=
        std::string::npos);
}

TEST_CASE("numbers that are none, and numbers without end, are refused") {
  for (const char* number : {"nan", "inf", "1e999", "0x10", "1,5", "", "--2", "2.5.1"}) {
    CAPTURE(std::string(number));
    CHECK(refusal(R"(xyz="0 0 0.1")", "xyz=\"0 0 " + std::string(number) + "\"") != "accepted");
    CHECK(refusal(R"(<mass value="2"/>)", "<mass value=\"" + std::string(number) + "\"/>") !=
          "accepted");
    CHECK(refusal(R"(upper="2.5")", "upper=\"" + std::string(number) + "\"") != "accepted");
  }
}

TEST_CASE("a number that is none is refused with the name of its link or joint") {
  CHECK(refusal(R"(<mass value="2"/>)", R"(<mass value="nan"/>)") ==
        "link `upper` has value=\"nan\" in its mass; expected finite numbers");
  CHECK(refusal(R"(upper="2.5")", R"(upper="1e999")") ==
        "joint `shoulder` has upper=\"1e999\" in its limit; expected finite numbers");
  CHECK(refusal(R"(axis xyz="0 0 2")", R"(axis xyz="0 0 two")").find("joint `elbow` has xyz=") ==
        0);
}

TEST_CASE("an inertia that no body has is left out, and only forces miss it") {
  for (const auto& [from, to, fault] :
       {std::array{R"(ixx="0.01")", R"(ixx="0.1")", "has principal moments"},
        std::array{R"(ixx="0.01")", R"(ixx="-0.1")", "has an inertia with the negative"},
        std::array{R"(<mass value="2"/>)", R"(<mass value="-2"/>)", "has mass = -2"}}) {
    const std::string written(to);
    CAPTURE(written);
    const Result<Mechanism> read = read_urdf(replaced(kArm, from, to));
    REQUIRE(read.ok());
    const Body& upper = read->bodies()[static_cast<std::size_t>(read->body("upper"))];
    CHECK(upper.inertia_fault.starts_with(fault));
    CHECK(upper.link.mass == 0.0);
    const Result<RobotSpec> spec = serial_arm(*read, "fore");
    REQUIRE(spec.ok());
    CHECK(spec->no_dynamics.find("link `upper` " + std::string(fault)) != std::string::npos);
    REQUIRE(spec->notes.size() == 1);
    const Robot robot(*spec);
    const Robot whole(*serial_arm(*read_urdf(kArm), "fore"));
    const Eigen::Vector2d q(0.3, -0.4);
    CHECK(difference(forward(robot, q), forward(whole, q)) == 0.0);
  }
  // No joint moves the stand.
  const Result<RobotSpec> aside = serial_arm(
      *read_urdf(replaced(kArm, R"(<link name="base"/>)",
                          R"(<link name="base"><inertial><mass value="-1"/><inertia ixx="1" ixy="0"
      ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>)")),
      "fore");
  REQUIRE(aside.ok());
  CHECK(aside->no_dynamics.empty());
  CHECK(aside->notes.size() == 1);
}

TEST_CASE("what is left of a xacro file is reported") {
  CHECK(refusal("</robot>", "<xacro:ur_robot prefix=\"\"/></robot>").find("<xacro:ur_robot>") !=
        std::string::npos);
  CHECK(refusal("</robot>", "<!-- <xacro:a/> --></robot>") == "accepted");
}

TEST_CASE("a missing mesh is left out with the name of its link") {
  const std::string text = replaced(
      kArm, R"(<link name="fore"/>)",
      R"(<link name="fore"><visual><geometry><mesh filename="package://small/fore.stl"/></geometry></visual></link>)");
  CHECK(read_urdf(text).ok());
  const Result<Mechanism> missing =
      read_urdf(text, {.has_mesh = [](const std::string&) { return false; }});
  REQUIRE(missing.ok());
  REQUIRE(missing->spec().notes.size() == 1);
  CHECK(missing->spec().notes[0].starts_with(
      "the mesh \"package://small/fore.stl\" of link `fore` is not there"));
  const Result<Mechanism> there =
      read_urdf(text, {.has_mesh = [](const std::string&) { return true; }});
  REQUIRE(there.ok());
  CHECK(there->bodies()[static_cast<std::size_t>(there->body("fore"))].link.mesh ==
        "package://small/fore.stl");
}

TEST_CASE("text that is no description, and text that attacks its reader, is refused") {
  CHECK(refusal("") == "the file is empty");
  CHECK(refusal(" \n ") == "the file is empty");
  CHECK(refusal("robot") != "accepted");
  CHECK(refusal("<robot>") != "accepted");
  CHECK(refusal("<html></html>") != "accepted");
  CHECK(refusal("<robot name=\"a\"><link name=\"b\">") != "accepted");
  CHECK(refusal(std::string("<robot\0name=\"a\"/>", 18)).find("U+0000") != std::string::npos);
  CHECK(refusal("<robot name=\"a\">\n<link name=\"b\x02\"/></robot>")
            .find("the control character U+0002, which XML does not allow (line 2)") !=
        std::string::npos);
  CHECK(
      refusal("<robot name=\"a\">\n<link name=\"b&#x1f;\"/></robot>").find("&#x1f; is a control") !=
      std::string::npos);
  CHECK(refusal("<?xml version=\"1.0\"?><!DOCTYPE lolz [<!ENTITY lol \"lol\">]><robot name=\"a\"/>")
            .find("document type") != std::string::npos);
  std::string deep, quoted;
  for (int i = 0; i < 200'000; ++i) {
    deep += "<a>";
    quoted += "<a b=\"/>\">";
  }
  CHECK(refusal(deep).find("nested more than 100 deep (line 1)") != std::string::npos);
  CHECK(refusal(quoted).find("nested more than 100 deep") != std::string::npos);
  CHECK(refusal(std::string(17 << 20, 'x')).find("bytes; at most") != std::string::npos);
}

TEST_CASE("what would keep the parser busy for minutes is counted before it sees the text") {
  const auto many = [](int count, const std::function<std::string(int)>& piece) {
    std::string text;
    for (int i = 0; i < count; ++i) text += piece(i);
    return text;
  };
  const auto robot = [](const std::string& inside) {
    return "<robot name=\"r\"><link name=\"l\"" + inside + "</robot>";
  };
  const std::string attributes =
      many(200'000, [](int i) { return " a" + std::to_string(i) + "=\"\""; });
  CHECK(refusal(robot(attributes + "/>")) ==
        "<link> has 200001 attributes; at most 100 are read (line 1)");
  CHECK(refusal(robot("/>" + many(150'000, [](int) { return "<a/>"; }))) ==
        "the file has 150002 elements; at most 100000 are read");
  CHECK(refusal(robot("/>" + many(150'000, [](int) { return "&lt;"; }))) ==
        "the file has 150000 entities; at most 100000 are read");
  CHECK(refusal(robot("/>" + many(20'000, [](int) { return "<!-- -->"; }))) ==
        "the file has 20000 comments, instructions and sections of plain text; at most 10000 are "
        "read");
  CHECK(refusal(robot("/>\n<" + std::string(300'000, 'n') + "/>")) ==
        "a name has 300000 bytes; at most 200 are read (line 2)");
  CHECK(refusal(robot(" type=\"" + std::string(300'000, '0') + "\"/>")) ==
        "a value in <link> has 300000 bytes; at most 10000 are read (line 1)");
  CHECK(refusal(robot("/>" + std::string(1'000'001, 'x'))) ==
        "the text between two tags has 1000001 bytes; at most 1000000 are read (line 1)");
  const auto chain = [&](int links) {
    return robot("/>" + many(links - 1, [](int i) {
                   const std::string n = std::to_string(i);
                   return "<link name=\"l" + n + "\"/><joint name=\"j" + n +
                          "\" type=\"fixed\"><parent link=\"l" +
                          (i == 0 ? "" : std::to_string(i - 1)) + "\"/><child link=\"l" + n +
                          "\"/></joint>";
                 }));
  };
  CHECK(refusal(chain(1001)) == "accepted");
  CHECK(refusal(chain(1002)) == "the description has 1002 links; at most 1001 are read");
  CHECK(refusal(chain(20'000)) == "the description has 20000 links; at most 1001 are read");
}

TEST_CASE("a text that our scan and the parser might read differently is refused, with its line") {
  const auto said = [](const std::string& text) {
    return refusal("<robot name=\"r\">\n" + text + "</robot>");
  };
  CHECK(said("<link name=\"a\"b=\"c\"/>") == "a blank is missing in the tag <link> (line 2)");
  CHECK(said("<link name=a/>") == "an attribute of <link> is not written name=\"value\" (line 2)");
  CHECK(said("<link name/>") == "an attribute of <link> is not written name=\"value\" (line 2)");
  CHECK(said("<link =\"a\"/>") == "an attribute of <link> has no name (line 2)");
  CHECK(said("<link name=\"a<b\"/>") ==
        "the value of an attribute of <link> holds a <, which is written &lt; (line 2)");
  CHECK(said("<link name=\"a & b\"/>") ==
        "a & begins no entity; a & itself is written &amp; (line 2)");
  CHECK(said("a &#x00000000000041; b") ==
        "a & begins no entity; a & itself is written &amp; (line 2)");
  CHECK(said("a < b") == "a < begins no tag; a < itself is written &lt; (line 2)");
  CHECK(said("</ >") == "a </ is not followed by a name (line 2)");
  CHECK(said("</robot a>") == "a closing tag holds more than a name (line 2)");
  CHECK(said("<!-- ") == "a comment does not end (line 2)");
  CHECK(said("<![CDATA[ ") == "a section of plain text does not end (line 2)");
  CHECK(said("<?xml ") == "an instruction does not end (line 2)");
  CHECK(said("<link name=\"a") == "the value of an attribute of <link> does not end (line 2)");
  CHECK(refusal("<robot name=\"a\"").find("the tag <robot> does not end") == 0);
  // Each of these begins a tag that has no end: looking for it from each would never end.
  std::string open;
  for (int i = 0; i < 2'000'000; ++i) open += "<a ";
  CHECK(refusal(open) == "an attribute of <a> has no name (line 1)");
  CHECK(refusal("<robot name=\"&quot;a&#65;&#x42;&apos;\"><link name=\"&lt;b&gt;\"/></robot>")
            .find("1 to 1000") != std::string::npos);
}

TEST_CASE("a long chain is read, and is too long for an arm") {
  std::string text = "<robot name=\"snake\"><link name=\"l0\"/>";
  for (int i = 1; i <= 900; ++i) {
    text += "<link name=\"l" + std::to_string(i) + "\"/><joint name=\"j" + std::to_string(i) +
            "\" type=\"continuous\"><parent link=\"l" + std::to_string(i - 1) +
            "\"/><child link=\"l" + std::to_string(i) + "\"/></joint>";
  }
  const Result<Mechanism> snake = read_urdf(text + "</robot>");
  REQUIRE(snake.ok());
  CHECK(serial_arm(*snake).error().message.find("900 joints; an arm has 1 to 12") !=
        std::string::npos);
}

TEST_CASE("cut and changed descriptions are read or refused, never more") {
  Random random(44);
  const std::string text = kArm;
  for (int k = 0; k < 2000; ++k) {
    std::string broken = text.substr(
        0, static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size()))));
    if (k % 2 == 0) {
      broken = text;
      for (int c = 0; c < 3; ++c) {
        broken[static_cast<std::size_t>(random.uniform(0, static_cast<double>(text.size())))] =
            static_cast<char>(random.uniform(1, 127));
      }
    }
    const Result<Mechanism> read = read_urdf(broken);
    if (!read.ok()) CHECK_FALSE(read.error().message.empty());
  }
}

TEST_CASE("meshes are found beside the description and in its package, and not above the top") {
  namespace fs = std::filesystem;
  const fs::path top = fs::temp_directory_path() / "armlet_urdf_test";
  fs::remove_all(top);
  fs::create_directories(top / "arm" / "urdf");
  fs::create_directories(top / "arm" / "meshes");
  std::ofstream(top / "arm" / "meshes" / "a.stl") << "solid";
  std::ofstream(top / "arm" / "urdf" / "b.stl") << "solid";
  const std::string folder = (top / "arm" / "urdf").string();
  CHECK_FALSE(find_mesh(folder, top.string(), "package://arm/meshes/a.stl").empty());
  CHECK_FALSE(find_mesh(folder, (top / "arm").string(), "package://arm/meshes/a.stl").empty());
  CHECK_FALSE(find_mesh(folder, top.string(), "../meshes/a.stl").empty());
  CHECK_FALSE(find_mesh(folder, top.string(), "b.stl").empty());
  CHECK(find_mesh(folder, folder, "../meshes/a.stl").empty());
  CHECK(find_mesh(folder, folder, "package://arm/meshes/a.stl").empty());
  CHECK(find_mesh(folder, top.string(), "package://leg/meshes/a.stl").empty());
  CHECK(find_mesh(folder, top.string(), "package://arm").empty());
  CHECK(find_mesh(folder, "", "/etc").empty());
  const std::string arm = (top / "arm").string(), other = (top / "other").string();
  fs::create_directories(other);
  const std::string mesh = "package://arm/meshes/a.stl";
  CHECK(find_mesh(other, other, mesh).empty());
  CHECK_FALSE(find_mesh(other, other, mesh, {.named = {{"arm", arm}}}).empty());
  CHECK_FALSE(find_mesh(other, other, mesh, {.folders = {other, top.string()}}).empty());
  CHECK_FALSE(find_mesh(other, other, mesh, {.folders = {arm}}).empty());
  CHECK(find_mesh(other, other, mesh, {.named = {{"leg", arm}}}).empty());
  fs::remove_all(top);
}
