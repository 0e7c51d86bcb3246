#include "armlet/cell/collisions.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

#include "armlet/cell/gripper.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Trajectory move_to(const Cell& cell, int robot, const VectorXd& q1) {
  const CellRobot& arm = cell.robot(robot);
  MotionPlan plan = plan_joint_move(PlannerSet(), *arm.model, {.q0 = arm.q, .q1 = q1});
  REQUIRE(plan.ok());
  return *std::move(plan.trajectory);
}

Object box_at(const std::string& name, const Vector3d& size, const Vector3d& p,
              bool fixed = false) {
  Object object;
  object.name = name;
  object.shape = Box{size};
  object.T_world_obj.translation() = p;
  object.fixed = fixed;
  return object;
}

void run_to_end(Cell& cell) {
  while (cell.next_event()) cell.advance_to(*cell.next_event());
}

// Its gripper has a length of its own, so that there is room for it.
std::shared_ptr<const Robot> with_gripper() {
  return std::make_shared<const Robot>(
      make_robot("scara")->with_tool(parallel_gripper(0.060, 0.150)));
}

// A SCARA whose tool point is 30 mm above a cube of 40 mm that stands on a table.
struct Bench {
  Cell cell;
  int arm = 0;
  Vector3d p_tool;
  VectorXd q;

  Bench() : arm(cell.add_robot(with_gripper(), "arm")) {
    q = cell.robot(arm).q;
    p_tool = cell.T_world_tool(arm).translation();
    cell.insert(box_at("table", {0.3, 0.3, 0.1}, p_tool - Vector3d(0.0, 0.0, 0.12), true));
    cell.insert(box_at("cube", {0.04, 0.04, 0.04}, p_tool - Vector3d(0.0, 0.0, 0.05)));
  }

  // The tool point by this much lower; the joint of this arm points down.
  [[nodiscard]] Trajectory down(double way) const {
    VectorXd lower = cell.robot(arm).q;
    lower[2] += way;
    return move_to(cell, arm, lower);
  }
  void go(const Trajectory& motion) {
    cell.start(arm, motion);
    run_to_end(cell);
  }
};

}  // namespace

TEST_CASE("a gripper goes down to a cube, takes it, lifts it and puts it down: no collision") {
  Bench bench;
  const auto free = [&](const Trajectory& motion) {
    const auto met = find_collisions(bench.cell, bench.arm, motion);
    for (const CellCollision& each : met)
      MESSAGE(body_text(bench.cell, each.body)
              << " and " << body_text(bench.cell, each.other) << " by " << each.depth);
    CHECK(met.empty());
    bench.go(motion);
  };
  free(bench.down(0.05));
  REQUIRE(grasp(bench.cell, bench.arm, "cube").ok());
  free(bench.down(-0.05));
  free(bench.down(0.05));
  release(bench.cell, bench.arm);
  free(bench.down(-0.05));
}

// The column of an arm rotates, but being round it occupies the same space.
TEST_CASE("an arm that stands on a table, or in a hole of it, does not hit it") {
  Bench bench;
  bench.cell.insert(box_at("bench top", {0.4, 0.4, 0.1}, {0.0, 0.0, -0.02}, true));
  VectorXd aside = bench.q;
  aside[0] -= 1.0;
  CHECK(find_collisions(bench.cell, bench.arm, move_to(bench.cell, bench.arm, aside)).empty());
}

TEST_CASE("what is carried runs into what is lower, and the message has numbers for it") {
  Bench bench;
  bench.go(bench.down(0.05));
  REQUIRE(grasp(bench.cell, bench.arm, "cube").ok());
  bench.go(bench.down(-0.04));
  const auto met = find_collisions(bench.cell, bench.arm, bench.down(0.05));
  REQUIRE(met.size() >= 1);
  CHECK(met[0].body.object == "cube");
  CHECK(met[0].other.object == "table");
  CHECK(met[0].depth == doctest::Approx(0.01).epsilon(1e-3));
  CHECK(met[0].higher == doctest::Approx(0.01).epsilon(0.02));
  CHECK(met[0].at_end);
  CHECK_FALSE(met[0].at_start);
  CHECK(body_text(bench.cell, met[0].body) == "\"cube\"");
}

TEST_CASE("a wall as an obstacle of the tool, and of a link") {
  Bench bench;
  VectorXd aside = bench.q;
  aside[0] -= 1.0;
  CHECK(find_collisions(bench.cell, bench.arm, move_to(bench.cell, bench.arm, aside)).empty());
  VectorXd half = bench.q;
  half[0] -= 0.5;
  const Vector3d p = forward(*bench.cell.robot(bench.arm).model, half).translation();
  bench.cell.insert(box_at("wall", {0.001, 0.2, 0.1}, p + Vector3d(0.0, 0.0, 0.02), true));
  const auto met = find_collisions(bench.cell, bench.arm, move_to(bench.cell, bench.arm, aside));
  REQUIRE(met.size() == 1);
  CHECK(met[0].other.object == "wall");
  CHECK(is_hand(met[0].body.role));
  CHECK(met[0].t > 0.0);
  CHECK_FALSE(met[0].at_end);
  // Taken away, nothing is left of it.
  bench.cell.remove("wall");
  CHECK(find_collisions(bench.cell, bench.arm, move_to(bench.cell, bench.arm, aside)).empty());
}

TEST_CASE("another robot, at rest and in motion") {
  Cell cell;
  const std::shared_ptr<const Robot> model = make_robot("planar2");
  const int left = cell.add_robot(model, "left");
  const auto other = std::make_shared<const Robot>(
      model->with_base(Isometry3d(Eigen::Translation3d(1.6 * model->reach(), 0.0, 0.0))));
  const int right = cell.add_robot(other, "right");
  const auto q = [](double angle) { return VectorXd(Eigen::Vector2d(angle, 0.0)); };
  const double pi = std::numbers::pi;
  cell.set_joints(left, q(1.5));
  cell.set_joints(right, q(pi));
  const auto met = find_collisions(cell, left, move_to(cell, left, q(0.0)));
  REQUIRE(met.size() == 1);
  CHECK(met[0].other.robot == right);
  // It leaves, and is away in time: both start at once and take as long.
  cell.start(right, move_to(cell, right, q(pi - 2.0)));
  CHECK(find_collisions(cell, left, move_to(cell, left, q(0.0))).empty());
  run_to_end(cell);
  cell.start(right, move_to(cell, right, q(pi)));
  CHECK(find_collisions(cell, left, move_to(cell, left, q(0.0))).size() == 1);
}

TEST_CASE("two arms at one position are alternatives") {
  Bench bench;
  const int other = bench.cell.add_robot(make_robot("ur5"), "other");
  VectorXd aside = bench.q;
  aside[0] -= 1.0;
  CHECK(find_collisions(bench.cell, bench.arm, move_to(bench.cell, bench.arm, aside)).empty());
  const CellBody arm{.robot = bench.arm}, second{.robot = other};
  CHECK(distance_between(bench.cell, arm, second) < 0.0);
}

TEST_CASE("distances in a cell") {
  Bench bench;
  const CellBody cube{.object = "cube"}, table{.object = "table"}, arm{.robot = bench.arm};
  CHECK(std::abs(distance_between(bench.cell, cube, table)) < 1e-9);
  CHECK(distance_between(bench.cell, arm, table) == doctest::Approx(0.07).epsilon(1e-6));
  // The fingers end beside the tool point, 30 mm above the cube.
  CHECK(distance_between(bench.cell, arm, cube) ==
        doctest::Approx(std::hypot(0.03, 0.01)).epsilon(1e-6));
  CHECK(distance_between(bench.cell, cube, arm) ==
        doctest::Approx(distance_between(bench.cell, arm, cube)));
}

}  // namespace armlet
