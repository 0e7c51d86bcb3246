// Velocity commands of a cell: one takes over from the other while the robot moves.
#include <doctest/doctest.h>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/velocity.hpp"

using namespace armlet;

namespace {

constexpr std::int64_t kHold = 40'000'000;  // ns

int drive(Cell& cell, double rate) {
  const CellRobot& arm = cell.robot(0);
  const Eigen::VectorXd rates = Eigen::Vector4d(rate, 0.0, 0.0, 0.0);
  const VelocityPlan plan =
      plan_joint_velocity(*arm.model, {arm.q, arm.qd, arm.qdd, to_seconds(kHold)}, rates);
  return cell.drive(0, plan.motion.value(), cell.now_ns() + kHold);
}

}  // namespace

TEST_CASE("a velocity command that follows another goes on with its speed") {
  Cell cell;
  cell.add_robot(make_robot("scara"));
  const int first = drive(cell, 0.5);
  CHECK_FALSE(cell.can_drive(0));
  CHECK_THROWS_AS(drive(cell, 0.5), ArgumentError);
  cell.advance_to(kHold);
  CHECK(cell.can_drive(0));
  const double speed = cell.robot(0).qd[0];
  const int second = drive(cell, 0.2);
  CHECK(cell.robot(0).qd[0] == doctest::Approx(speed));
  CHECK(cell.report(first).state == MotionState::kReached);
  CHECK(cell.report(first).end_ns == kHold);
  CHECK(cell.report(second).held_ns == 2 * kHold);
  cell.advance_to(2'000'000'000);
  CHECK_FALSE(cell.is_moving(0));
  CHECK(cell.report(second).state == MotionState::kReached);
  CHECK(cell.robot(0).qd.norm() == 0.0);
}

TEST_CASE("a robot that halts takes no velocity until it stands") {
  Cell cell;
  cell.add_robot(make_robot("scara"));
  drive(cell, 0.5);
  cell.advance_to(kHold);
  cell.halt(0);
  REQUIRE(cell.is_moving(0));
  CHECK_FALSE(cell.can_drive(0));
  cell.advance_to(1'000'000'000);
  CHECK(cell.can_drive(0));
}

TEST_CASE("a velocity command that begins with another speed or elsewhere is refused") {
  Cell cell;
  cell.add_robot(make_robot("scara"));
  const Eigen::VectorXd q = cell.robot(0).q;
  const Robot& model = *cell.robot(0).model;
  const Eigen::VectorXd rates = Eigen::Vector4d(0.1, 0.0, 0.0, 0.0);
  const auto fast = plan_joint_velocity(model, {.q = q, .qd = rates, .during = 0.04}, rates);
  CHECK_THROWS_AS(cell.drive(0, *fast.motion, kHold), ArgumentError);
  const auto elsewhere = plan_joint_velocity(
      model, {.q = q + rates, .qd = Eigen::VectorXd::Zero(4), .during = 0.04}, rates);
  CHECK_THROWS_AS(cell.drive(0, *elsewhere.motion, kHold), ArgumentError);
}
