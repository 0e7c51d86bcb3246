// Motions under forces, which are given to a cell piece by piece.
#include <doctest/doctest.h>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

constexpr std::int64_t kPiece = 10'000'000;  // ns

// All joints speed up evenly from a state, for longer than a hold.
Trajectory piece(const CellRobot& arm, double accel) {
  std::vector<JointPath> joints;
  for (Eigen::Index i = 0; i < arm.q.size(); ++i) {
    Segment segment{.start = 0.0, .duration = 0.02, .degree = 2};
    segment.c[0] = arm.q[i];
    segment.c[1] = arm.qd[i];
    segment.c[2] = 0.5 * accel;
    joints.push_back({.segments = {segment}, .q_end = segment.value(0.02)});
  }
  return Trajectory(std::move(joints), 0.02);
}

int push(Cell& cell, double accel) {
  const CellRobot& arm = cell.robot(0);
  return cell.push(0, piece(arm, accel), Eigen::VectorXd::Constant(arm.q.size(), accel));
}

}  // namespace

TEST_CASE("pieces under forces are one motion, however time is cut, and end at rest") {
  for (const std::int64_t part : {kPiece, kPiece / 3}) {
    Cell cell;
    cell.add_robot(make_robot("puma560"));
    const CellRobot& arm = cell.robot(0);
    const Eigen::VectorXd start = arm.q;
    const int motion = push(cell, 1.0);
    for (int k = 1; k <= 3; ++k) {
      while (cell.now_ns() < k * kPiece)
        cell.advance_to(std::min(k * kPiece, cell.now_ns() + part));
      CHECK(cell.is_moving(0));
      CHECK(arm.qd[0] == doctest::Approx(0.01 * k).epsilon(1e-12));
      CHECK(cell.take_events().empty());
      CHECK(cell.report(motion).state == MotionState::kRunning);
      CHECK(push(cell, 1.0) == motion);
    }
    CHECK(arm.forces[2] == 1.0);
    CHECK(arm.q[0] == doctest::Approx(start[0] + 0.5 * 0.03 * 0.03).epsilon(1e-12));
    CHECK_THROWS_AS(cell.start(0, Trajectory::at_rest(arm.q, 1.0)), ArgumentError);
    cell.settle(0);
    CHECK(arm.forces.size() == 0);
    CHECK(arm.qd[0] == doctest::Approx(0.03).epsilon(1e-6));
    cell.advance_to(cell.report(motion).end_ns);
    CHECK_FALSE(cell.is_moving(0));
    CHECK(arm.qd.isZero(0.0));
    CHECK(cell.report(motion).state == MotionState::kReached);
    CHECK(cell.take_events().size() == 1);
  }
}

TEST_CASE("a motion under forces is stopped and halted as others are, and its arm may change") {
  for (const bool halted : {false, true}) {
    Cell cell;
    cell.add_robot(make_robot("puma560"));
    const CellRobot& arm = cell.robot(0);
    const int motion = push(cell, 2.0);
    cell.advance_to(kPiece / 2);
    cell.set_model(0, std::make_shared<const Robot>(arm.model->with_payload({.mass = 1.0})));
    CHECK(arm.loaded->payload().mass == 1.0);
    halted ? cell.halt(0) : cell.stop(0);
    cell.advance_to(cell.report(motion).end_ns);
    CHECK_FALSE(cell.is_moving(0));
    CHECK(cell.report(motion).state == MotionState::kStopped);
    CHECK(cell.report(motion).halted == halted);
  }
}

TEST_CASE("an arm that is faster than its limits comes to rest inside of its range") {
  Cell cell;
  cell.add_robot(make_robot("puma560"));
  const CellRobot& arm = cell.robot(0);
  push(cell, 400.0);
  cell.advance_to(kPiece);
  push(cell, 400.0);
  cell.advance_to(2 * kPiece);
  CHECK(arm.qd[0] == doctest::Approx(8.0).epsilon(1e-9));
  cell.settle(0);
  cell.advance_to(*cell.next_event());
  CHECK_FALSE(cell.is_moving(0));
  CHECK((arm.q.array() >= arm.model->lower().array()).all());
  CHECK((arm.q.array() <= arm.model->upper().array()).all());
}
