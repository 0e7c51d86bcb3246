#include "armlet/model/catalog.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

#include "armlet/kinematics/limits.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/angles.hpp"
#include "reference_robot.hpp"

using namespace armlet;

namespace {

const std::map<std::string, std::string> kReferenceOf = {
    {"planar2", "twolink"},      {"rrr3", "rrr3"},       {"scara", "scara_rrpr"},
    {"scorbot", "scorbot_er4u"}, {"puma560", "puma560"}, {"stanford", "stanford"},
    {"pa10_6", "pa10_6"},        {"pa10", "pa10_7"},     {"ur5", "ur5"},
    {"panda", "panda"}};

}  // namespace

TEST_CASE("the arms are those of the reference files") {
  for (const auto& [name, file] : kReferenceOf) {
    const auto& shown = name;  // clang 14 captures no binding
    CAPTURE(shown);
    const Robot robot = *make_robot(name);
    const Robot reference = reference::robot_of(reference::load(file).at("robot"));
    REQUIRE(robot.n() == reference.n());
    CHECK(robot.T_world_base().isApprox(reference.T_world_base(), 1e-12));
    CHECK(robot.T_flange_tool().isApprox(reference.T_flange_tool(), 1e-12));
    for (int i = 0; i < robot.n(); ++i) {
      CAPTURE(i);
      const Joint &a = robot.joint(i), &b = reference.joint(i);
      CHECK(a.kind == b.kind);
      CHECK(std::abs(a.dh.theta - b.dh.theta) < 1e-12);
      CHECK(a.dh.d == b.dh.d);
      CHECK(a.dh.a == b.dh.a);
      CHECK(std::abs(a.dh.alpha - b.dh.alpha) < 1e-12);
      // The language fixes the last joint of the SCARA at one revolution to either side.
      const bool wider = name == "scara" && i == 3;
      CHECK(std::abs(a.lower - (wider ? -2 * kPi : b.lower)) < 1e-12);
      CHECK(std::abs(a.upper - (wider ? 2 * kPi : b.upper)) < 1e-12);
      const Link &k = robot.link(i), &l = reference.link(i);
      CHECK(k.mass == l.mass);
      CHECK(k.com == l.com);
      CHECK(k.inertia.isApprox(l.inertia, 1e-12));
      CHECK(k.motor_inertia == l.motor_inertia);
      CHECK(k.gear == l.gear);
      CHECK(k.friction.viscous == l.friction.viscous);
      CHECK(k.friction.coulomb_plus == l.friction.coulomb_plus);
      CHECK(k.friction.coulomb_minus == l.friction.coulomb_minus);
    }
  }
}

TEST_CASE("every arm names its source and starts away from its limits and singularities") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const std::shared_ptr<const Robot> robot = make_robot(name);
    REQUIRE(robot);
    CHECK(robot->name() == name);
    CHECK_FALSE(robot->source().empty());
    CHECK(limit_violations(*robot, robot->home()).empty());
    CHECK(singularity(*robot, robot->home()).sigma_min > 0.02);
    CHECK(robot->tool().can_grasp() == (robot->n() >= 4));
  }
}

TEST_CASE("arms with a wrist start with the tool pointing down") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    if (robot.n() < 4 || name == "scorbot") continue;  // its rest position is its maker's
    const Eigen::Isometry3d T = forward(robot, robot.home());
    CHECK((T.linear().col(2) + Eigen::Vector3d::UnitZ()).norm() < 1e-12);
    CHECK(T.translation().z() > 0.0);
  }
}

TEST_CASE("every entry of the catalogue says what its arm is, under names of its own") {
  std::map<std::string, std::string> meant;
  for (const CatalogArm& entry : catalog_arms()) {
    CAPTURE(entry.name);
    CHECK(make_robot(entry.name)->source() == entry.source);
    CHECK(entry.help.ends_with('.'));
    for (const std::string_view name : {entry.name, entry.second_name}) {
      if (name.empty()) continue;
      CHECK(meant.emplace(name, entry.name).second);
      CHECK(make_robot(name)->name() == entry.name);
    }
  }
}

TEST_CASE("an unknown name gives no arm") {
  CHECK(make_robot("") == nullptr);
  CHECK(make_robot("r2d2") == nullptr);
  CHECK(make_robot("rrr3")->name() == "anthropomorphic");
  CHECK(make_robot("iiwa")->name() == "iiwa14");
}
