// Objects and frames on robots: they move with it, weigh on it, collide with it.
#include <doctest/doctest.h>

#include <algorithm>

#include "armlet/backend/recorder.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/cell/collisions.hpp"
#include "armlet/core/error.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kGravity = 9.81;  // of arms unless declared otherwise

Trajectory way_to(const Cell& cell, int robot, const Eigen::VectorXd& q, double time) {
  const PlannerSet planners;
  const CellRobot& arm = cell.robot(robot);
  return *plan_joint_move(planners, *arm.model,
                          {.q0 = arm.q, .q1 = q, .time = time, .enforce_limits = false})
              .trajectory;
}

Object brick(std::string name, const Vector3d& p, const Vector3d& size, double mass = 0.0) {
  return {.name = std::move(name),
          .shape = Box{size},
          .T_world_obj = make_translation(p),
          .mass = mass};
}

Mount on_link(int robot, int frame) {
  return {.base = FrameBase::kCarrier, .carrier = robot, .frame = frame};
}

double apart(const Isometry3d& a, const Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("what is on a link is where the link is, at every instant, and its poses are reported") {
  Recorder recorder;
  Cell cell;
  cell.set_backend(&recorder);
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  for (int frame = 0; frame <= 6; ++frame) {
    cell.insert(brick("b" + std::to_string(frame), {0.01, 0.02, 0.03}, {0.01, 0.01, 0.01}),
                on_link(arm, frame));
    cell.insert_frame({.name = "f" + std::to_string(frame),
                       .base = FrameBase::kCarrier,
                       .T_on_frame = make_translation({0.1, 0.0, 0.0}),
                       .carrier = arm,
                       .frame = frame});
  }
  cell.insert(brick("knob", {0.0, 0.0, 0.1}, {0.01, 0.01, 0.01}),
              {.base = FrameBase::kObject, .on = "b4"});
  cell.insert(brick("tip", {0.0, 0.0, 0.2}, {0.01, 0.01, 0.01}),
              {.base = FrameBase::kFrame, .on = "f6"});
  Eigen::VectorXd q(6);
  q << 0.6, -0.4, 0.3, 0.2, -0.5, 1.0;
  cell.start(arm, way_to(cell, arm, q, 1.0));
  for (int step = 0; step <= 50; ++step) {
    cell.advance_to(step * 20'000'000LL);
    const CellRobot& now = cell.robot(arm);
    for (int frame = 0; frame <= 6; ++frame) {
      const Isometry3d T =
          frame == 0 ? now.model->T_world_base() : link_frame(*now.model, now.q, frame);
      const std::string number = std::to_string(frame);
      CHECK(apart(cell.world().at("b" + number).T_world_obj,
                  T * make_translation({0.01, 0.02, 0.03})) < 1e-14);
      CHECK(apart(*cell.world().T_world_frame("f" + number),
                  T * make_translation({0.1, 0.0, 0.0})) < 1e-14);
    }
    CHECK(apart(cell.world().at("knob").T_world_obj,
                cell.world().at("b4").T_world_obj * make_translation({0.0, 0.0, 0.1})) < 1e-14);
    CHECK(apart(cell.world().at("tip").T_world_obj,
                *cell.world().T_world_frame("f6") * make_translation({0.0, 0.0, 0.2})) < 1e-14);
  }
  cell.end();
  for (const char* name : {"b1", "b6", "knob", "tip"}) {
    const auto of_it = [&](const auto& sample) { return sample.name == name; };
    CHECK(std::ranges::count_if(recorder.objects(), of_it) > 90);
  }
}

TEST_CASE("what is mounted weighs on the arm, on its own link") {
  Cell bare, loaded;
  for (Cell* cell : {&bare, &loaded}) cell->add_robot(make_robot("puma560"), "arm");
  loaded.insert(brick("weight", {0.0, 0.0, 0.0}, {0.1, 0.1, 0.1}, 3.0), on_link(0, 3));
  const auto gravity = [](const Cell& cell) {
    Eigen::VectorXd q(6);
    q << 0.1, -0.3, 0.2, 0.4, 0.5, 0.6;
    return gravity_forces(*cell.robot(0).loaded, q);
  };
  const Eigen::VectorXd more = gravity(loaded) - gravity(bare);
  CHECK(std::abs(more[1]) > 1.0);
  CHECK(more.tail<3>().cwiseAbs().maxCoeff() < 1e-9);  // behind that link nothing changes
  // The same as the gradient of its height.
  Eigen::VectorXd q(6);
  q << 0.1, -0.3, 0.2, 0.4, 0.5, 0.6;
  const Robot& arm = *bare.robot(0).model;
  for (int joint = 0; joint < 3; ++joint) {
    constexpr double kStep = 1e-6;
    Eigen::VectorXd a = q, b = q;
    a[joint] -= kStep;
    b[joint] += kStep;
    const double rise =
        link_frame(arm, b, 3).translation().z() - link_frame(arm, a, 3).translation().z();
    CHECK(more[joint] == doctest::Approx(3.0 * kGravity * rise / (2.0 * kStep)).epsilon(1e-4));
  }
}

TEST_CASE("mounted bodies collide with objects as parts of the arm") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"), "arm");
  // A mast on the second link, and a beam over the path that only the mast can hit.
  const double top = link_frame(*cell.robot(arm).model, cell.robot(arm).q, 2).translation().z();
  cell.insert(brick("mast", {-0.1, 0.0, -0.4}, {0.02, 0.02, 0.2}, 0.1), on_link(arm, 2));
  const Vector3d p = cell.world().at("mast").T_world_obj.translation();
  Eigen::VectorXd q = cell.robot(arm).q;
  q[0] += 1.0;
  Isometry3d turned = Isometry3d::Identity();
  turned.rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitZ()));
  const Vector3d on_way = turned * p;
  cell.insert(brick("beam", {on_way.x(), on_way.y(), p.z() + 0.05}, {0.05, 0.05, 0.05}));
  CHECK(p.z() > top + 0.2);
  const auto found = find_collisions(cell, arm, way_to(cell, arm, q, 1.0));
  REQUIRE(found.size() == 1);
  CHECK(body_text(cell, found[0].body) == "\"mast\"");
  CHECK(body_text(cell, found[0].other) == "\"beam\"");
  q[0] -= 2.0;
  CHECK(find_collisions(cell, arm, way_to(cell, arm, q, 1.0)).empty());
}

TEST_CASE("an arm meets what stands on its own first link") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  Eigen::VectorXd q(6);
  q << 0.0, 0.3, -1.2, 0.0, 0.4, 0.0;
  cell.set_joints(arm, q);
  const Isometry3d T_1 = cell.T_world_link(arm, 1);
  Eigen::VectorXd over = q;
  over[1] -= 0.8;
  // Where the tool comes by.
  const Vector3d p =
      T_1.inverse() * forward(*cell.robot(arm).model, 0.5 * (q + over)).translation();
  cell.insert(brick("post", p, {0.05, 0.05, 0.05}), on_link(arm, 1));
  const auto found = find_collisions(cell, arm, way_to(cell, arm, over, 1.0));
  REQUIRE_FALSE(found.empty());
  CHECK(body_text(cell, found[0].other) == "\"post\"");
  CHECK(found[0].body.object.empty());
}

TEST_CASE("a gripper takes what stands on a tray of its own arm and puts it there again") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"), "arm");
  cell.insert(brick("tray", {0.3, 0.0, 0.0}, {0.1, 0.1, 0.01}, 0.5), on_link(arm, 1));
  const Vector3d p = cell.world().at("tray").T_world_obj.translation();
  cell.insert(brick("cup", {p.x(), p.y(), p.z() + 0.03}, {0.03, 0.03, 0.05}, 0.1));
  CHECK(cell.world().attachment("cup")->on == "tray");
  cell.take(arm, "cup");
  CHECK(cell.world().carried_by(arm) == "cup");
  CHECK(cell.held_wrench(arm)[2] == doctest::Approx(-0.1 * kGravity));
  const Drop drop = cell.let_go(arm);
  CHECK(drop.support == "tray");
  CHECK(cell.world().attachment("cup")->mounted);
  CHECK_THROWS_AS(cell.insert(brick("x", {0, 0, 0}, {0.1, 0.1, 0.1}), on_link(arm, 5)),
                  ArgumentError);
  CHECK_THROWS_AS(
      cell.insert(brick("x", {0, 0, 0}, {0.1, 0.1, 0.1}), {.base = FrameBase::kObject, .on = "no"}),
      ArgumentError);
  CHECK(cell.world().find("x") == nullptr);
}
