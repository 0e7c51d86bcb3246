#include "armlet/cell/cell.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "armlet/backend/recorder.hpp"
#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

const Eigen::Vector4d kPick(0.61, 0.94, 0.11, -0.33);

Trajectory move_to(const Cell& cell, int robot, const Eigen::VectorXd& q, double time) {
  const PlannerSet planners;
  const CellRobot& arm = cell.robot(robot);
  return *plan_joint_move(planners, *arm.model,
                          {.q0 = arm.q, .q1 = q, .time = time, .enforce_limits = false})
              .trajectory;
}

Object cube(const Eigen::Vector3d& p) {
  Object object{.name = "cube", .shape = Box{{0.04, 0.04, 0.04}}};
  object.T_world_obj = make_translation(p);
  return object;
}

// Two arms, one motion each, one stopped; for the recorder.
void run_two_arms(Recorder* recorder, std::int64_t step_ns) {
  Cell cell;
  cell.set_backend(recorder);
  cell.add_robot(make_robot("scara"), "a");
  cell.add_robot(make_robot("scara"), "b");
  cell.insert(cube({0.3, 0.2, 0.5}));
  cell.take(0, "cube");
  cell.start(0, move_to(cell, 0, kPick, 1.0));
  const int second = cell.start(
      1, move_to(cell, 1, -0.4 * kPick.cwiseProduct(Eigen::Vector4d(1, 1, -1, 1)), 0.8005));
  while (cell.now_ns() < 400'000'000) cell.advance_to(cell.now_ns() + step_ns);
  cell.stop(1);
  while (cell.now_ns() < 1'200'000'000) cell.advance_to(cell.now_ns() + step_ns);
  CHECK(cell.report(second).state == MotionState::kStopped);
  cell.let_go(0);
  cell.end();
}

}  // namespace

TEST_CASE("a robot starts at home and ends a motion exactly on its target") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  CHECK(cell.robot(arm).q == cell.robot(arm).model->home());
  const int motion = cell.start(arm, move_to(cell, arm, kPick, 2.0));
  CHECK(cell.is_moving(arm));
  CHECK(cell.next_event() == 2'000'000'000);
  cell.advance_to(1'000'000'000);
  CHECK(cell.robot(arm).qd.norm() > 0.1);
  CHECK(cell.report(motion).state == MotionState::kRunning);
  cell.advance_to(*cell.next_event());
  CHECK(cell.robot(arm).q == kPick);
  CHECK(cell.robot(arm).qd.isZero(0.0));
  CHECK_FALSE(cell.is_moving(arm));
  CHECK_FALSE(cell.next_event().has_value());
  CHECK(cell.report(motion).state == MotionState::kReached);
  const std::vector<CellEvent> events = cell.take_events();
  REQUIRE(events.size() == 1);
  CHECK(events[0].motion == motion);
  CHECK(events[0].t_ns == 2'000'000'000);
  CHECK(cell.take_events().empty());
}

TEST_CASE("samples come at multiples of the period, at the start and at the exact end") {
  Recorder recorder;
  Cell cell;
  cell.set_backend(&recorder);
  const int arm = cell.add_robot(make_robot("scara"));
  cell.advance_to(3'000'000);
  cell.start(arm, move_to(cell, arm, kPick, 0.5255));
  cell.advance_to(2'000'000'000);
  cell.end();
  const auto& joints = recorder.joints();
  REQUIRE(joints.size() == 2 + 52 + 1);  // home, start, 10 ms to 520 ms, end
  CHECK(joints[0].t_ns == 0);
  CHECK(joints[1].t_ns == 3'000'000);
  CHECK(joints[2].t_ns == 10'000'000);
  CHECK(joints[53].t_ns == 520'000'000);
  CHECK(joints[54].t_ns == 528'500'000);
  CHECK(joints[54].q == std::vector<double>(kPick.begin(), kPick.end()));
  CHECK(joints[54].T_world_tool == forward(*cell.robot(arm).model, kPick).matrix());
  CHECK(recorder.end_ns() == 2'000'000'000);
}

TEST_CASE("the same run gives the same record, however time is cut into steps") {
  Recorder one, two, three;
  run_two_arms(&one, 1'000'000);
  run_two_arms(&two, 1'000'000);
  run_two_arms(&three, 400'000);
  CHECK(one.same_as(two));
  CHECK(one.same_as(three));
  CHECK(one.joints().size() > 100);
}

TEST_CASE("who listens changes nothing") {
  Recorder recorder;
  Eigen::VectorXd q[2];
  for (int listening = 0; listening < 2; ++listening) {
    Cell cell;
    if (listening == 1) cell.set_backend(&recorder);
    cell.add_robot(make_robot("scara"));
    cell.start(0, move_to(cell, 0, kPick, 1.0));
    cell.advance_to(333'333'333);
    cell.stop(0);
    cell.advance_to(3'000'000'000);
    q[listening] = cell.robot(0).q;
  }
  CHECK(q[0] == q[1]);
}

TEST_CASE("a held object keeps its pose in the gripper through a whole motion, bit by bit") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  cell.insert(cube({0.5, 0.1, 0.3}));
  cell.take(arm, "cube");
  const Eigen::Isometry3d T_flange_obj = cell.world().attachment("cube")->T_carrier_obj;
  cell.start(arm, move_to(cell, arm, kPick, 1.0));
  for (std::int64_t t = 1'000'000; t <= 1'000'000'000; t += 1'000'000) {
    cell.advance_to(t);
    CHECK(cell.world().at("cube").T_world_obj.matrix() ==
          (cell.T_world_flange(arm) * T_flange_obj).matrix());
  }
  CHECK(cell.world().attachment("cube")->T_carrier_obj.matrix() == T_flange_obj.matrix());
}

TEST_CASE("an object that is passed on stays with the gripper that took it") {
  Cell cell;
  cell.add_robot(make_robot("scara"), "left");
  cell.add_robot(make_robot("scara"), "right");
  cell.insert(cube({0.5, 0.1, 0.3}));
  cell.take(0, "cube");
  cell.take(1, "cube");
  const Drop drop = cell.let_go(0);
  CHECK(drop.support.empty());
  CHECK(cell.robot(0).held.empty());
  CHECK(cell.robot(1).held == "cube");
  CHECK(cell.world().attachment("cube")->carrier == 1);
  // The other way round: whoever keeps it carries it.
  cell.take(0, "cube");
  cell.let_go(0);
  CHECK(cell.world().attachment("cube")->carrier == 1);
}

TEST_CASE("moving the tool point leaves what is held where it is") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  cell.insert(cube({0.5, 0.1, 0.3}));
  cell.take(arm, "cube");
  const Eigen::Matrix4d before = cell.world().at("cube").T_world_obj.matrix();
  const Robot longer = cell.robot(arm).model->with_tool_point(make_translation({0.0, 0.0, 0.1}));
  cell.set_model(arm, std::make_shared<const Robot>(longer));
  CHECK(cell.T_world_tool(arm).translation().z() == doctest::Approx(0.25));
  CHECK(cell.world().at("cube").T_world_obj.matrix() == before);
  cell.set_joints(arm, kPick);
  cell.set_joints(arm, cell.robot(arm).model->home());
  CHECK(cell.world().at("cube").T_world_obj.matrix().isApprox(before, 1e-14));
}

TEST_CASE("a motion that takes no time ends when its instant is visited again") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  const int motion = cell.start(arm, Trajectory::at_rest(cell.robot(arm).q, 0.0));
  CHECK(cell.next_event() == 0);
  cell.advance_to(0);
  CHECK(cell.report(motion).state == MotionState::kReached);
}

TEST_CASE("ticks are multiples of the tick, after now") {
  Cell cell;
  CHECK(cell.next_tick() == 1'000'000);
  cell.advance_to(1'000'000);
  CHECK(cell.next_tick() == 2'000'000);
  cell.advance_to(2'500'001);
  CHECK(cell.next_tick() == 3'000'000);
}

TEST_CASE("notes before the first motion wait for the robots; later robots are announced") {
  Recorder recorder;
  Cell cell;
  cell.set_backend(&recorder);
  cell.note(NoteKind::kOutput, "hello");
  CHECK(recorder.notes().empty());
  cell.add_robot(make_robot("scara"));
  cell.advance_to(1);
  CHECK(recorder.run().robots.size() == 1);
  CHECK(recorder.notes()[0].text == "hello");
  cell.add_robot(make_robot("puma560"));
  CHECK(recorder.run().robots.size() == 2);
  CHECK(recorder.run().robots[0].joints[2].unit == JointUnit::kMetre);
  CHECK(recorder.joints().back().robot == 1);
}

TEST_CASE("a held object is neither removed nor put elsewhere") {
  Recorder recorder;
  Cell cell;
  cell.set_backend(&recorder);
  const int arm = cell.add_robot(make_robot("scara"));
  cell.begin();
  cell.insert(cube({0.5, 0.1, 0.3}));
  cell.add_to_task("cube");
  cell.add_to_task("cube");
  CHECK(cell.task_objects().size() == 1);
  cell.take(arm, "cube");
  CHECK(cell.holder_of("cube") == arm);
  CHECK_THROWS_AS((void)cell.set_pose("cube", make_translation({0.1, 0.2, 0.3})), ArgumentError);
  CHECK_THROWS_AS((void)cell.remove(cell.robot(arm).held), ArgumentError);
  CHECK(cell.robot(arm).held == "cube");
  cell.let_go(arm);
  CHECK_FALSE(cell.holder_of("cube").has_value());
  cell.remove("cube");
  CHECK(cell.task_objects().empty());
  REQUIRE(recorder.events().size() == 3);
  CHECK(recorder.events()[1].change == ObjectChange::kDetached);
  CHECK(recorder.events()[2].change == ObjectChange::kRemoved);
}

TEST_CASE("what rests on a held body is reported with it, and what loses its support as fallen") {
  Recorder recorder;
  Cell cell(World(0.0));
  cell.set_backend(&recorder);
  const int arm = cell.add_robot(make_robot("scara"));
  cell.begin();
  cell.insert(cube({0.5, 0.1, 0.22}));  // the arm lowers it by 0.11 m
  Object lid = cube({0.5, 0.1, 0.26});
  lid.name = "lid";
  cell.insert(lid);
  cell.take(arm, "cube");
  cell.start(arm, move_to(cell, arm, kPick, 1.0));
  cell.advance_to(1'000'000'000);
  const Eigen::Isometry3d T =
      cell.world().at("cube").T_world_obj.inverse() * cell.world().at("lid").T_world_obj;
  CHECK((T.translation() - Eigen::Vector3d(0.0, 0.0, 0.04)).norm() < 1e-15);
  const auto is_lid = [](const auto& sample) { return sample.name == "lid"; };
  CHECK(std::ranges::count_if(recorder.objects(), is_lid) > 50);
  cell.let_go(arm);
  CHECK(cell.world().resting_on("lid") == "cube");
  const auto falls = cell.set_pose("cube", make_translation({0.2, -0.3, 0.02}));
  REQUIRE(falls.size() == 1);
  CHECK(falls[0].drop.support == "floor");
  CHECK(recorder.events().back().change == ObjectChange::kFell);
  CHECK(recorder.events().back().name == "lid");
}

TEST_CASE("what cannot be is refused") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  CHECK_THROWS_AS((void)cell.add_robot(make_robot("scara")), ArgumentError);
  CHECK_THROWS_AS((void)cell.add_robot(nullptr), ArgumentError);
  CHECK_THROWS_AS((void)cell.robot(1), ArgumentError);
  CHECK_THROWS_AS((void)cell.robot(-1), ArgumentError);
  CHECK_THROWS_AS((void)cell.report(0), ArgumentError);
  CHECK_THROWS_AS((void)cell.let_go(arm), ArgumentError);
  CHECK_THROWS_AS(cell.take(arm, "nothing"), ArgumentError);
  CHECK_THROWS_AS(cell.add_to_task("nothing"), ArgumentError);
  CHECK_THROWS_AS((void)cell.start(arm, Trajectory::at_rest(kPick, 1.0)), ArgumentError);
  cell.start(arm, move_to(cell, arm, kPick, 1.0));
  CHECK_THROWS_AS((void)cell.start(arm, Trajectory::at_rest(cell.robot(arm).q, 1.0)),
                  ArgumentError);
  CHECK_THROWS_AS(cell.set_joints(arm, kPick), ArgumentError);
  cell.advance_to(5);
  CHECK_THROWS_AS(cell.advance_to(4), ArgumentError);
  CHECK_THROWS_AS(Cell(World(), {.tick_ns = 0}), ArgumentError);
  CHECK(cell.contact_wrench(arm).isZero(0.0));
}
