#include "armlet/cell/gripper.hpp"

#include <doctest/doctest.h>

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

const Eigen::Vector4d kHome(0.0, 0.0, 0.0, 0.0);
const Eigen::Vector4d kAbove(0.61, 0.94, 0.02, -0.33);
const Eigen::Vector4d kPick(0.61, 0.94, 0.11, -0.33);
const Eigen::Vector4d kOver(-0.7853981633974483, 1.20, 0.02, 0.45);
const Eigen::Vector4d kPlace(-0.7853981633974483, 1.20, 0.11, 0.45);

Object thing(std::string name, Shape shape, const Eigen::Vector3d& p) {
  Object object{.name = std::move(name), .shape = shape};
  object.T_world_obj = make_translation(p);
  return object;
}

// A table under the SCARA, its top at 220 mm, a cube and a cylinder on it.
World table_world() {
  World world(0.0);
  Object table = thing("table", Box{{0.60, 1.20, 0.22}}, {0.50, 0.10, 0.11});
  table.fixed = true;
  world.insert(table);
  world.insert(thing("cube", Box{{0.04, 0.04, 0.04}}, {0.334, 0.529, 0.24}));
  world.insert(thing("cylinder", Cylinder{0.02, 0.05}, {0.35, 0.15, 0.245}));
  return world;
}

void move(Cell& cell, const Eigen::VectorXd& q, double time) {
  const PlannerSet planners;
  const CellRobot& arm = cell.robot(0);
  const MotionPlan plan = plan_joint_move(
      planners, *arm.model, {.q0 = arm.q, .q1 = q, .time = time, .enforce_limits = false});
  REQUIRE(plan.ok());
  cell.start(0, *plan.trajectory);
  cell.advance_to(*cell.next_event());
}

}  // namespace

TEST_CASE("the classic pick and place carries the cube by contact and puts it down") {
  Cell cell(table_world(), {.contact_picking = true});
  cell.add_robot(make_robot("scara"));
  cell.add_to_task("cube");
  const Eigen::Isometry3d T_start = cell.world().at("cube").T_world_obj;
  const Eigen::Isometry3d T_tool_start = forward(*cell.robot(0).model, kPick);
  std::vector<CellEvent> contacts;
  const auto go = [&](const Eigen::VectorXd& q, double time) {
    move(cell, q, time);
    for (const CellEvent& event : cell.take_events()) {
      if (event.kind != CellEventKind::kMotionEnded) contacts.push_back(event);
    }
  };
  go(kAbove, 2.0);
  CHECK(contacts.empty());
  go(kPick, 1.0);
  CHECK(holding(cell, 0) == "cube");
  go(kAbove, 1.0);
  go(kOver, 2.0);
  CHECK(holding(cell, 0) == "cube");
  go(kPlace, 1.0);
  CHECK(holding(cell, 0).empty());
  go(kOver, 1.0);
  go(kHome, 2.0);
  CHECK(cell.now_ns() == 10'000'000'000);
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[0].kind == CellEventKind::kPicked);
  CHECK(contacts[0].t_ns == 3'000'000'000);
  CHECK(contacts[1].kind == CellEventKind::kPutDown);
  CHECK(contacts[1].t_ns == 7'000'000'000);
  CHECK(contacts[1].support == "table");
  // The cube went along rigidly, then settled on the table.
  const Eigen::Isometry3d T_tool_end = forward(*cell.robot(0).model, kPlace);
  const Eigen::Isometry3d T_expected = T_tool_end * T_tool_start.inverse() * T_start;
  const Eigen::Isometry3d T_end = cell.world().at("cube").T_world_obj;
  CHECK((T_end.translation() - T_expected.translation()).norm() < 1e-12);
  CHECK(T_end.translation().z() == doctest::Approx(0.24).epsilon(1e-12));
  CHECK((T_end.translation() - T_start.translation()).norm() > 0.5);
}

TEST_CASE("contact picking does not let go where it picked up, nor in the air") {
  Cell cell(table_world(), {.contact_picking = true});
  cell.add_robot(make_robot("scara"));
  cell.add_to_task("cube");
  move(cell, kPick, 2.0);
  CHECK(holding(cell, 0) == "cube");
  move(cell, kAbove, 1.0);
  move(cell, kPick, 1.0);
  CHECK(holding(cell, 0) == "cube");
  move(cell, kOver, 2.0);
  CHECK(holding(cell, 0) == "cube");
}

TEST_CASE("contact picking leaves alone what the task does not name") {
  Cell cell(table_world(), {.contact_picking = true});
  cell.add_robot(make_robot("scara"));
  cell.add_to_task("cylinder");
  move(cell, kPick, 2.0);
  CHECK(holding(cell, 0).empty());
}

TEST_CASE("grasping closes on the nearest object, by its centre or its grasp point") {
  Cell cell(table_world());
  cell.add_robot(make_robot("scara"));
  cell.set_joints(0, kPick);
  const GraspResult grasped = grasp(cell, 0);
  CHECK(grasped.ok());
  CHECK(grasped.object == "cube");
  CHECK(grasped.distance < 0.001);
  CHECK(grasp(cell, 0).status == GraspStatus::kHolding);
  CHECK(release(cell, 0)->object == "cube");
  CHECK_FALSE(release(cell, 0).has_value());
  Object tall = thing("tall", Box{{0.04, 0.04, 0.20}}, {0.0, 0.0, 0.0});
  tall.p_obj_grasp = Eigen::Vector3d(0.0, 0.0, 0.09);
  tall.T_world_obj =
      make_translation(cell.T_world_tool(0).translation() - Eigen::Vector3d(0.0, 0.0, 0.087));
  cell.insert(tall);
  const GraspResult by_point = grasp(cell, 0, "tall");
  CHECK(by_point.ok());
  CHECK(by_point.distance == doctest::Approx(0.003).epsilon(1e-9));
}

TEST_CASE("nothing within reach of the gripper names the nearest object and its distance") {
  Cell cell(table_world());
  cell.add_robot(make_robot("scara"));
  cell.set_joints(0, kAbove);
  const GraspResult nothing = grasp(cell, 0);
  CHECK(nothing.status == GraspStatus::kNothing);
  CHECK(nothing.object == "cube");
  CHECK(nothing.distance == doctest::Approx(0.09).epsilon(1e-3));
  CHECK(nothing.allowed == 0.005);
  CHECK(grasp(cell, 0, "cylinder").status == GraspStatus::kNothing);
  CHECK(grasp(cell, 0, "ball").status == GraspStatus::kUnknownObject);
  Cell empty;
  empty.add_robot(make_robot("scara"));
  CHECK(grasp(empty, 0).status == GraspStatus::kNothing);
  CHECK(grasp(empty, 0).object.empty());
}

TEST_CASE(
    "what is too wide or belongs to the cell is not grasped, and grasping nothing is refused") {
  Cell cell;
  cell.add_robot(make_robot("scara"));
  const Eigen::Vector3d p = cell.T_world_tool(0).translation();
  cell.insert(thing("wide", Box{{0.07, 0.08, 0.04}}, p));
  const GraspResult wide = grasp(cell, 0, "wide");
  CHECK(wide.status == GraspStatus::kTooWide);
  // At home the fingers close along the world's y axis.
  CHECK(wide.width == doctest::Approx(0.08));
  CHECK(wide.turned == doctest::Approx(0.07));
  CHECK(wide.stroke == 0.06);
  Object fixture = thing("fixture", Box{{0.02, 0.02, 0.02}}, p);
  fixture.fixed = true;
  cell.insert(fixture);
  CHECK(grasp(cell, 0, "fixture").status == GraspStatus::kFixed);
  const Robot bare = cell.robot(0).model->with_tool(point_tool());
  cell.set_model(0, std::make_shared<const Robot>(bare));
  CHECK(grasp(cell, 0).status == GraspStatus::kNoHand);
  const Robot sucking = bare.with_tool(suction_cup(0.01, 0.0));
  cell.set_model(0, std::make_shared<const Robot>(sucking));
  CHECK(grasp(cell, 0, "wide").ok());
}

TEST_CASE("what is released falls to the first surface") {
  Cell cell(table_world());
  cell.add_robot(make_robot("scara"));
  cell.set_joints(0, kPick);
  REQUIRE(grasp(cell, 0, "cube").ok());
  cell.set_joints(0, kOver);
  CHECK(cell.world().at("cube").T_world_obj.translation().z() == doctest::Approx(0.33));
  const auto released = release(cell, 0);
  CHECK(released->drop.support == "table");
  CHECK(released->drop.distance == doctest::Approx(0.09).epsilon(1e-9));
  CHECK(cell.world().at("cube").T_world_obj.translation().z() == doctest::Approx(0.24));
}
