#include "armlet/model/mechanism.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "armlet/core/error.hpp"

using namespace armlet;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A forearm on an upper arm.
MechanismSpec two_links() {
  MechanismSpec spec;
  spec.name = "arm";
  spec.bodies = {
      {.name = "upper", .joint_name = "shoulder", .joint = BodyJoint::kRevolute},
      {.name = "fore", .joint_name = "elbow", .parent = 0, .joint = BodyJoint::kRevolute}};
  spec.actuators = {{.name = "shoulder", .lower = -1, .upper = 1},
                    {.name = "elbow", .lower = -1, .upper = 1}};
  return spec;
}

template <class Change>
std::string refusal(Change change) {
  MechanismSpec spec = two_links();
  change(spec);
  try {
    const Mechanism made(spec);
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a broken mechanism is refused with the name of the link") {
  CHECK(refusal([](auto&) {}) == "accepted");
  CHECK(refusal([](auto& s) { s.bodies[1].parent = 1; }) ==
        "Link `fore` of `arm` is its own parent.");
  CHECK(refusal([](auto& s) { s.bodies[0].parent = 1; }) ==
        "Link `upper` of `arm` hangs on `fore`, which comes after it; a parent comes first.");
  CHECK(refusal([](auto& s) { s.bodies[1].parent = 7; }) ==
        "Link `fore` of `arm` has the parent number 7, which is no link.");
  CHECK(refusal([](auto& s) { s.bodies[1].name = "upper"; }) ==
        "Link `upper` of `arm` has the name of another link.");
  CHECK(refusal([](auto& s) { s.bodies[1].axis.setZero(); }) ==
        "Link `fore` of `arm` has a joint with the axis (0, 0, 0), which has no direction.");
  CHECK(refusal([](auto& s) { s.bodies[1].T_parent_joint.translation().x() = kNan; }) ==
        "Link `fore` of `arm` has a place that is not finite.");
  CHECK(refusal([](auto& s) { s.bodies[1].T_parent_joint.linear() *= 1.1; }) ==
        "Link `fore` of `arm` has an orientation that is not a rotation.");
  CHECK(refusal([](auto& s) { s.bodies[1].link.mass = kNan; }) ==
        "Link `fore` of `arm` has mass = nan; expected a finite number.");
  CHECK(refusal([](auto& s) { s.bodies[1].link.mass = -1; }) ==
        "Link `fore` of `arm` has mass = -1; it must be zero or more.");
  CHECK(
      refusal([](auto& s) { s.bodies[1].link.inertia.diagonal() << 1, 1, 3; }) ==
      "Link `fore` of `arm` has principal moments 1, 1, 3 kg m^2; in a rigid body none exceeds the "
      "sum of the other two.");
  CHECK(refusal([](auto& s) { s.actuators[1].lower = 2; }) ==
        "Actuator `elbow` of `arm` has its limits swapped: 2 is above 1.");
  CHECK(refusal([](auto& s) { s.actuators.pop_back(); }).find("coupling of `arm`") !=
        std::string::npos);
  CHECK(refusal([](auto& s) { s.bodies.clear(); }).find("0 links") != std::string::npos);
  CHECK(refusal([](auto& s) {
          s.tips.push_back({"hand", 5});
        }).find("`hand`") != std::string::npos);
}

TEST_CASE("published inertias are accepted where they are asked for") {
  CHECK(refusal([](auto& s) {
          s.bodies[1].link.inertia.diagonal() << 1, 1, 3;
          s.inertia_check = InertiaCheck::kPublished;
        }) == "accepted");
}

TEST_CASE("joints follow their actuators") {
  MechanismSpec spec = two_links();
  spec.actuators.pop_back();
  spec.coupling = Eigen::Vector2d(1.0, -0.5);
  spec.offset = Eigen::Vector2d(0.0, 0.25);
  const Mechanism m(spec);
  CHECK(m.actuator_count() == 1);
  CHECK(m.joint_count() == 2);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.5);
  CHECK(m.joint_values(q) == Eigen::Vector2d(0.5, 0.0));
  CHECK_THROWS_AS(m.joint_values(Eigen::Vector2d::Zero()), ArgumentError);
}

TEST_CASE("links and tips are found by name") {
  MechanismSpec spec = two_links();
  spec.tips.push_back({"hand", 1, Eigen::Isometry3d::Identity()});
  const Mechanism m(spec);
  CHECK(m.body("fore") == 1);
  CHECK(m.tip("hand").body == 1);
  CHECK_THROWS_WITH_AS(m.body("leg"), "`arm` has no link `leg`.", ArgumentError);
  CHECK_THROWS_WITH_AS(m.tip("leg"), "`arm` has no tip `leg`.", ArgumentError);
}
