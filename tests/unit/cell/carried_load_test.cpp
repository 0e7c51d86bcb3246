// What a tool carries counts in the dynamics of its arm.
#include <doctest/doctest.h>

#include "armlet/cell/cell.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

Object brick(std::string name, const Eigen::Isometry3d& T_world_obj, double mass) {
  Object object{.name = std::move(name), .shape = Box{{0.04, 0.06, 0.02}}};
  object.T_world_obj = T_world_obj;
  object.mass = mass;
  return object;
}

Eigen::VectorXd weight(const Cell& cell, int robot = 0) {
  const CellRobot& arm = cell.robot(robot);
  return gravity_forces(*arm.loaded, arm.q);
}

}  // namespace

TEST_CASE("a grasped body counts until it is released, and so does what rests on it") {
  Cell cell(World(0.0));
  cell.add_robot(make_robot("puma560"));
  const CellRobot& arm = cell.robot(0);
  CHECK(arm.loaded == arm.model);
  const Eigen::VectorXd empty = weight(cell);
  const Eigen::Isometry3d T =
      make_translation(cell.T_world_tool(0).translation() + Eigen::Vector3d(0.1, 0.0, -0.05));
  cell.insert(brick("brick", T, 2.0));
  CHECK(arm.loaded == arm.model);
  cell.take(0, "brick");

  // The weight of the body, as a force at its centre.
  const auto pull = [&](double mass) {
    const Robot at_centre = arm.model->with_tool_point(cell.T_world_flange(0).inverse() *
                                                       cell.world().at("brick").T_world_obj);
    Vector6d w = Vector6d::Zero();
    w.head<3>() = mass * arm.model->gravity();
    return Eigen::VectorXd(wrench_forces(at_centre, arm.q, -w));
  };
  CHECK((weight(cell) - empty - pull(2.0)).norm() < 1e-12);

  cell.set_model(0, std::make_shared<const Robot>(arm.model->with_payload({.mass = 0.0})));
  CHECK((weight(cell) - empty - pull(2.0)).norm() < 1e-12);

  // A second one on it, straight above.
  cell.insert(brick("rider", make_translation({0.0, 0.0, 0.02}) * T, 0.5));
  const Payload both = arm.loaded->payload();
  CHECK(both.mass == 2.5);
  const Eigen::Isometry3d T_flange_rider =
      cell.T_world_flange(0).inverse() * cell.world().at("rider").T_world_obj;
  const Eigen::Isometry3d T_flange_brick =
      cell.T_world_flange(0).inverse() * cell.world().at("brick").T_world_obj;
  CHECK(
      (both.com - 0.8 * T_flange_brick.translation() - 0.2 * T_flange_rider.translation()).norm() <
      1e-12);

  (void)cell.let_go(0);
  CHECK(arm.loaded == arm.model);
  CHECK((weight(cell) - empty).norm() == 0.0);
}

TEST_CASE("a body that two grippers hold is carried by the one that it follows") {
  Cell cell(World(0.0));
  cell.add_robot(make_robot("puma560"), "left");
  cell.add_robot(make_robot("puma560"), "right");
  cell.insert(brick("brick", cell.T_world_tool(0), 1.0));
  cell.take(0, "brick");
  CHECK(cell.robot(0).loaded != cell.robot(0).model);
  cell.take(1, "brick");
  CHECK(cell.robot(0).loaded == cell.robot(0).model);
  CHECK(cell.robot(1).loaded != cell.robot(1).model);
  (void)cell.let_go(1);
  CHECK(cell.robot(0).loaded != cell.robot(0).model);
  CHECK(cell.robot(1).loaded == cell.robot(1).model);
}
