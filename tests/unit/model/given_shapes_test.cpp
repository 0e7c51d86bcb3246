// Shapes and masses that a description gives to links and to the base, from the text to what is
// drawn.

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/model/robot_scene.hpp"
#include "armlet/model/serial_arm.hpp"

using namespace armlet;

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A plate that is fixed to the root, with a mass of 30 kg; a post of 12 kg stands on it. The first
// joint is 0.3 m up and 0.1 m aside, about the axis y of its frame. The last link is a ball.
constexpr const char* kOnTable = R"(<?xml version="1.0"?>
<robot name="small">
  <link name="world"/>
  <joint name="a" type="fixed"><parent link="world"/><child link="table"/><origin xyz="0 0 0.2"/></joint>
  <link name="table"><inertial><origin xyz="0.1 0 -0.02"/><mass value="30"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1.5"/></inertial>
    <visual><origin xyz="0.2 0 -0.05"/><geometry><box size="1 0.8 0.1"/></geometry></visual></link>
  <joint name="b" type="fixed"><parent link="table"/><child link="post"/><origin xyz="0.3 0.1 0" rpy="0 0 1.5708"/></joint>
  <link name="post"><inertial><mass value="12"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <visual><geometry><box size="0.1 0.1 0.3"/></geometry></visual>
    <collision><origin xyz="0.02 0 0"/><geometry><cylinder radius="0.08" length="0.3"/></geometry></collision></link>
  <joint name="first" type="revolute"><parent link="table"/><child link="upper"/>
    <origin xyz="0 0.1 0.3" rpy="0.3 0.2 0.1"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="9" velocity="3"/></joint>
  <link name="upper"><visual><origin xyz="0.2 0 0"/><geometry><box size="0.4 0.3 0.2"/></geometry></visual></link>
  <joint name="second" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.4 0 0"/><axis xyz="0 0 1"/><limit lower="-2" upper="2" effort="9" velocity="3"/></joint>
  <link name="fore"><collision><origin xyz="0.1 0 0"/><geometry><sphere radius="0.06"/></geometry></collision></link>
</robot>)";

Robot on_table() {
  Result<RobotSpec> spec = serial_arm_of_urdf(kOnTable, {});
  REQUIRE(spec.ok());
  return Robot(std::move(spec).value());
}

// The corners of the parts of a node, in the world.
struct Extent {
  Vector3d low = Vector3d::Constant(1e9), high = Vector3d::Constant(-1e9);
};
Extent extent_of(const GlbScene& scene, std::size_t node) {
  Isometry3d T = Isometry3d::Identity();
  for (int at = static_cast<int>(node); at >= 0;
       at = scene.nodes[static_cast<std::size_t>(at)].parent)
    T = scene.nodes[static_cast<std::size_t>(at)].T_parent_node * T;
  Extent extent;
  for (const GlbPart& part : scene.nodes[node].parts) {
    for (const Eigen::Vector3f& each : part.positions) {
      extent.low = extent.low.cwiseMin(T * each.cast<double>());
      extent.high = extent.high.cwiseMax(T * each.cast<double>());
    }
  }
  return extent;
}

}  // namespace

TEST_CASE("the root and what is fixed to it are the base: masses, shapes and names") {
  const Robot robot = on_table();
  const Link& base = robot.spec().base;
  CHECK(base.mass == doctest::Approx(42.0));
  // In the world: (30 (0.1, 0, 0.18) + 12 (0.3, 0.1, 0.2)) / 42.
  const Vector3d com = robot.T_world_base() * base.com;
  CHECK((com - Vector3d(6.6, 1.2, 7.8) / 42.0).norm() < 1e-12);
  CHECK(base.names == std::vector<std::string>{"world", "table", "post"});
  CHECK(robot.body(1).names == std::vector<std::string>{"upper"});
  REQUIRE(base.solids.size() == 3);
  CHECK(base.solids[0].use == LinkSolidUse::kBoth);
  const Isometry3d T_world_plate = robot.T_world_base() * base.solids[0].T_link_solid;
  CHECK((T_world_plate.translation() - Vector3d(0.2, 0.0, 0.15)).norm() < 1e-12);
  CHECK(T_world_plate.linear().isIdentity(1e-12));
  // The post has one shape for collisions, a quarter revolution from its frame, and another for
  // pictures.
  CHECK(base.solids[1].use == LinkSolidUse::kCollision);
  CHECK(base.solids[2].use == LinkSolidUse::kPicture);
  const Vector3d p_post = robot.T_world_base() * base.solids[1].T_link_solid.translation();
  CHECK((p_post - Vector3d(0.3, 0.12, 0.2)).norm() < 1e-12);
}

TEST_CASE("simple shapes of a description are drawn where it says, and no column is") {
  const Robot robot = on_table();
  const GlbScene scene = robot_scene(robot);
  const Extent base = extent_of(scene, 0);
  CHECK((base.low - Vector3d(-0.3, -0.4, 0.05)).norm() < 1e-6);
  CHECK((base.high - Vector3d(0.7, 0.4, 0.35)).norm() < 1e-6);
  // The box of the first link, at the zero of its joint.
  const Isometry3d T_world_upper =
      Eigen::Translation3d(0.0, 0.1, 0.5) * Isometry3d((Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) *
                                                        Eigen::AngleAxisd(0.2, Vector3d::UnitY()) *
                                                        Eigen::AngleAxisd(0.3, Vector3d::UnitX()))
                                                           .toRotationMatrix());
  Extent wanted;
  for (const double x : {0.0, 0.4}) {
    for (const double y : {-0.15, 0.15}) {
      for (const double z : {-0.1, 0.1}) {
        wanted.low = wanted.low.cwiseMin(T_world_upper * Vector3d(x, y, z));
        wanted.high = wanted.high.cwiseMax(T_world_upper * Vector3d(x, y, z));
      }
    }
  }
  const Extent upper = extent_of(scene, 1);
  CHECK((upper.low - wanted.low).norm() < 1e-6);
  CHECK((upper.high - wanted.high).norm() < 1e-6);
  const Extent ball = extent_of(scene, 2);
  const Vector3d middle = T_world_upper * Vector3d(0.5, 0.0, 0.0);
  CHECK((0.5 * (ball.low + ball.high) - middle).norm() < 2e-3);  // of 32 faces
  CHECK((ball.high - ball.low).maxCoeff() == doctest::Approx(0.12).epsilon(1e-3));
}

TEST_CASE("an exported description has the shapes and the masses of links and base") {
  const Robot robot = on_table();
  const Result<RobotSpec> again =
      serial_arm_of_urdf(write_urdf(Mechanism(mechanism_of(robot))), {}, "tool");
  REQUIRE(again.ok());
  const Robot copy{RobotSpec(*again)};
  CHECK(copy.spec().base.mass == doctest::Approx(42.0));
  CHECK((copy.T_world_base() * copy.spec().base.com - robot.T_world_base() * robot.spec().base.com)
            .norm() < 1e-12);
  const Eigen::VectorXd q = Eigen::Vector2d(0.4, -0.7);
  for (int link = 0; link <= robot.n(); ++link) {
    const Isometry3d T = link_frame(robot, q, link), T_copy = link_frame(copy, q, link);
    const auto &one = robot.body(link).solids, &other = copy.body(link).solids;
    REQUIRE(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(one[i].size == other[i].size);
      const Isometry3d difference =
          (T * one[i].T_link_solid).inverse() * (T_copy * other[i].T_link_solid);
      CHECK(difference.isApprox(Isometry3d::Identity(), 1e-9));
    }
  }
}

TEST_CASE("an arm of a table is drawn on a column, an arm of which something was given is not") {
  RobotSpec spec;
  spec.joints = joints_from_table({{0, 0.3, 0.2, 0}, {0, 0, 0.3, 0}}, "RR");
  const auto of_base = [](const Robot& robot) {
    int count = 0;
    for (const LinkShape& each : link_shapes(robot)) count += each.link == 0 ? 1 : 0;
    return count;
  };
  const Robot plain{RobotSpec(spec)};
  CHECK(of_base(plain) > 0);
  spec.links.resize(2);
  spec.links[1].solids = {{.size = {0.3, 0.1, 0.1}}};
  const Robot given{RobotSpec(spec)};
  CHECK(of_base(given) == 0);
  CHECK_FALSE(pedestal_shapes(given).empty());
  spec.base.solids = {{.kind = LinkSolidKind::kSphere, .size = {0.1, 0.0, 0.0}}};
  CHECK(of_base(Robot(std::move(spec))) == 1);
}
