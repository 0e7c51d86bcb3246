#include "armlet/collision/arm_solids.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/robot_scene.hpp"
#include "armlet/model/tool.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Solid placed(const Robot& robot, const ArmSolid& own, const VectorXd& q) {
  Solid solid = own.solid;
  solid.T = link_frame(robot, q, own.frame) * own.solid.T;
  return solid;
}

VectorXd bent(const Robot& robot) {
  VectorXd q = robot.home();
  for (int i = 0; i < robot.n(); ++i) {
    const double middle =
        0.5 * (std::max(robot.lower()[i], -3.0) + std::min(robot.upper()[i], 3.0));
    q[i] = 0.7 * q[i] + 0.3 * middle + 0.05;
  }
  return q;
}

}  // namespace

// Bodies of neighbouring links meet at the joint between them wherever the joints are, so that a
// body placed by a wrong frame shows as a hole in the arm.
TEST_CASE("an arm has no holes, in whatever convention its table is") {
  for (const std::string_view name : catalog_names()) {
    // Without a gripper of its own it leaves room for one.
    const auto robot =
        std::make_shared<const Robot>(make_robot(name)->with_tool(parallel_gripper(0.060, 0.150)));
    CAPTURE(name);
    const auto& solids = robot->derived<ArmSolids>().solids();
    for (const VectorXd& q : {robot->home(), bent(*robot)}) {
      for (int link = 1; link <= robot->n(); ++link) {
        double nearest = 1e9;
        bool has = false;
        for (const ArmSolid& a : solids) {
          if (a.frame != link) continue;
          has = true;  // the base below the first of them is none
          for (const ArmSolid& b : solids) {
            if (b.frame >= link) continue;
            nearest =
                std::min(nearest, gap_between(placed(*robot, a, q), placed(*robot, b, q)).distance);
          }
        }
        CAPTURE(link);
        if (has && nearest < 1e9) CHECK(nearest < 0.05 * robot->reach());
      }
    }
  }
}

TEST_CASE("the bodies of an arm are the shapes that are drawn, where they are drawn") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = make_robot(name)->with_tool(
        {.kind = ToolKind::kParallelGripper, .stroke = 0.08, .length = 0.12});
    std::vector<Eigen::Isometry3d> nodes;
    for (const GlbNode& node : robot_scene(robot).nodes) {
      nodes.push_back(node.parent < 0
                          ? node.T_parent_node
                          : nodes[static_cast<std::size_t>(node.parent)] * node.T_parent_node);
    }
    const ArmSolids bodies(robot);
    std::size_t drawn = 0;
    for (const LinkShape& shape : link_shapes(robot)) {
      if (shape.role == LinkShapeRole::kMark || shape.link == 0) continue;
      ++drawn;
      const bool is_rod = shape.kind == LinkShapeKind::kCylinder &&
                          shape.role == LinkShapeRole::kLink;  // ends at the next frame
      const Eigen::Isometry3d T_world_shape =
          nodes[static_cast<std::size_t>(shape.link)] * shape.T_link_shape;
      const bool found = std::ranges::any_of(bodies.solids(), [&](const ArmSolid& each) {
        const Solid solid = placed(robot, each, robot.home());
        const Solid own = solid_of(shape);
        return each.role == shape.role && solid.core == own.core && solid.margin == own.margin &&
               (is_rod || (solid.half == own.half && solid.T.isApprox(T_world_shape, 1e-12)));
      });
      CHECK(found);
    }
    CHECK(drawn == bodies.solids().size());
  }
}

TEST_CASE("the fingers of a gripper end at the tool point, on both sides of it") {
  const auto robot =
      std::make_shared<const Robot>(make_robot("scara")->with_tool(parallel_gripper(0.060, 0.150)));
  const VectorXd q = bent(*robot);
  Solid point{.margin = 1e-6};
  point.T = forward(*robot, q);
  const double stroke = robot->tool().stroke;
  int fingers = 0;
  for (const ArmSolid& each : robot->derived<ArmSolids>().solids()) {
    const bool finger =
        each.role == LinkShapeRole::kFingerLeft || each.role == LinkShapeRole::kFingerRight;
    if (!finger) continue;
    ++fingers;
    CHECK(gap_between(placed(*robot, each, q), point).distance ==
          doctest::Approx(0.5 * stroke).epsilon(1e-3));
  }
  CHECK(fingers == 2);
}

TEST_CASE("an arm without a gripper of its own length ends in a stick, at the tool point") {
  for (const std::string_view name : catalog_names()) {
    const std::shared_ptr<const Robot> robot = make_robot(name);
    CAPTURE(name);
    if (!robot->derived<ArmSolids>().is_bare()) continue;
    const VectorXd q = bent(*robot);
    const Eigen::Isometry3d T_world_tool = forward(*robot, q);
    // A plate that the tool points at, 5 mm from the tool point, and as wide as a cube.
    Solid plate = solid_of(Shape(Box{{0.04, 0.04, 0.002}}));
    plate.T = T_world_tool * Eigen::Translation3d(0.0, 0.0, 0.006);
    for (const ArmSolid& each : robot->derived<ArmSolids>().solids()) {
      if (each.frame <= robot->derived<ArmSolids>().neighbour_of_last()) continue;
      CHECK(gap_between(placed(*robot, each, q), plate).distance > 0.0015);
    }
  }
}

TEST_CASE("a base is a body only where its shape was given") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const ArmSolids arm(*make_robot(name));
    CHECK(std::ranges::none_of(arm.solids(), [](const ArmSolid& each) { return each.frame == 0; }));
    CHECK_FALSE(arm.pedestal().empty());
  }
  RobotSpec spec = make_robot("ur5")->spec();
  LinkSolid plate{.size = {1.0, 1.2, 0.1}};
  plate.T_link_solid.translation() = Vector3d(0.2, 0.0, -0.05);
  LinkSolid picture = plate;
  picture.use = LinkSolidUse::kPicture;
  spec.base.solids = {plate, picture};
  const Robot robot(std::move(spec));
  const ArmSolids arm(robot);
  int of_base = 0;
  for (const ArmSolid& each : arm.solids()) {
    if (each.frame > 0) continue;
    ++of_base;
    CHECK(each.given);
    CHECK(each.still);
    CHECK(each.solid.half == Vector3d(0.5, 0.6, 0.05));
    CHECK(each.solid.T.translation() == plate.T_link_solid.translation());
  }
  CHECK(of_base == 1);
}

TEST_CASE("given bodies keep their thickness where the arm is compared with itself") {
  RobotSpec spec = make_robot("planar3")->spec();
  spec.links.resize(3);
  spec.links[0].solids = {{.kind = LinkSolidKind::kCylinder, .size = {0.04, 0.2, 0.0}}};
  const Robot robot(std::move(spec));
  const ArmSolids arm(robot);
  for (std::size_t i = 0; i < arm.solids().size(); ++i) {
    const ArmSolid &whole = arm.solids()[i], &slim = arm.slim()[i];
    if (whole.given) CHECK(whole.solid.half == slim.solid.half);
  }
}

}  // namespace armlet
