#include "armlet/stdlib/robot_text.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

// The robot that a program with this block has.
std::shared_ptr<const Robot> read_back(const std::string& block) {
  Session session(library_engine(), SessionOptions{});
  const bool good = session.compile(block, "robot.rbt");
  for (const Problem& problem : session.problems()) MESSAGE(problem.diagnostic.message);
  REQUIRE(good);
  const RunResult result = session.run();
  REQUIRE(result.status == Progress::kDone);
  return session.host()->cell().robot(0).model;
}

void check_equal(const Robot& a, const Robot& b) {
  REQUIRE(a.n() == b.n());
  CHECK(a.name() == b.name());
  CHECK(a.spec().convention == b.spec().convention);
  CHECK(a.lower() == b.lower());
  CHECK(a.upper() == b.upper());
  CHECK(a.max_speed() == b.max_speed());
  CHECK(a.max_accel() == b.max_accel());
  CHECK(a.max_jerk() == b.max_jerk());
  CHECK(a.home() == b.home());
  CHECK(a.gravity() == b.gravity());
  CHECK(a.tool().kind == b.tool().kind);
  CHECK(a.tool().stroke == b.tool().stroke);
  CHECK(a.tool().radius == b.tool().radius);
  for (int i = 0; i < a.n(); ++i) {
    CHECK(a.joint(i).max_effort == b.joint(i).max_effort);
    const Link &k = a.link(i), &l = b.link(i);
    CHECK(k.mass == l.mass);
    CHECK(k.com == l.com);
    CHECK(k.inertia == l.inertia);
    CHECK(k.motor_inertia == l.motor_inertia);
    CHECK(k.gear == l.gear);
    CHECK(k.friction.viscous == l.friction.viscous);
    CHECK(k.friction.coulomb_plus == l.friction.coulomb_plus);
    CHECK(k.friction.coulomb_minus == l.friction.coulomb_minus);
  }
  Random random(51);
  for (int k = 0; k < 100; ++k) {
    Eigen::VectorXd q(a.n());
    for (int i = 0; i < a.n(); ++i) q[i] = random.uniform(a.lower()[i], a.upper()[i]);
    CHECK((forward(a, q).matrix() - forward(b, q).matrix()).cwiseAbs().maxCoeff() < 1e-12);
  }
}

}  // namespace

TEST_CASE("every arm of the catalogue comes back from its block the same") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    check_equal(*read_back(robot_block(robot)), robot);
  }
}

TEST_CASE("base, tool point, gripper and gravity come back") {
  RobotSpec spec = make_robot("scorbot")->spec();
  spec.T_world_base = pose_from_rpy({0.1, -0.2, 1.0 / 3.0}, {0.3, -1.0, 2.5});
  spec.T_flange_tool = pose_from_rpy({0.01, 0.02, 0.03}, {0.0, 0.5, 0.1});
  spec.tool = suction_cup(0.0123, 0.055);
  spec.gravity = {0.0, -9.81, 0.5};
  const Robot robot(spec);
  check_equal(*read_back(robot_block(robot)), robot);
  const Robot hanging = make_robot("ur5")->with_tool(parallel_gripper(0.085, 0.13, 35.5));
  check_equal(*read_back(robot_block(hanging)), hanging);
}

TEST_CASE("a name that is none in the language becomes one") {
  CHECK(read_back(robot_block(make_robot("planar2")->with_name("arm 7-b")))->name() == "arm_7_b");
  CHECK(read_back(robot_block(make_robot("planar2")->with_name("7")))->name() == "robot_7");
}
