// Overloads and slips while robots move: grippers that are pressed too hard, objects that slip.
#include "armlet/cell/foresight.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/cell/fingers.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::int64_t kMilli = 1'000'000;

Trajectory motion_to(const Cell& cell, int robot, const VectorXd& q1, std::optional<double> time) {
  const CellRobot& arm = cell.robot(robot);
  JointMove move{.q0 = arm.q, .q1 = q1, .time = time, .enforce_limits = false};
  if (!time) move.speed = 1.0;
  MotionPlan plan = plan_joint_move(PlannerSet(), *arm.model, move);
  return *std::move(plan.trajectory);
}

// A gripper that stands 100 N, above a block: its fingers end 10 mm over it.
struct Pressing {
  Cell cell;
  int arm = 0;
  double stiffness = 2e4;

  Pressing() {
    Tool tool = parallel_gripper(0.06, 0.12);
    tool.max_force = 100.0;
    arm = cell.add_robot(std::make_shared<const Robot>(make_robot("scara")->with_tool(tool)));
    VectorXd q = cell.robot(arm).q;
    q[2] = 0.05;
    cell.set_joints(arm, q);
    Object block{
        .name = "block", .shape = Box{{0.2, 0.2, 0.05}}, .stiffness = stiffness, .fixed = true};
    block.T_world_obj =
        make_translation(cell.T_world_tool(arm).translation() - Vector3d(0.0, 0.0, 0.025 + gap()));
    cell.insert(block);
  }
  // From the tool point to the top of the block; fingers may be longer than to the tool point.
  static double gap() { return 0.03; }
  int lower(double by, double time) {
    VectorXd q = cell.robot(arm).q;
    q[2] += by;
    return cell.start(arm, motion_to(cell, arm, q, time));
  }
  [[nodiscard]] double force() const { return cell.contact_wrench(arm).head<3>().norm(); }
};

}  // namespace

TEST_CASE(
    "a motion stops at the nanosecond at which the hand is pressed harder than it can stand") {
  Pressing bench;
  const int motion = bench.lower(0.06, 2.0);
  bench.cell.advance_to(3000 * kMilli);
  const MotionReport& report = bench.cell.report(motion);
  REQUIRE(report.overload);
  CHECK(report.state == MotionState::kStopped);
  CHECK(report.end_ns < 2000 * kMilli);
  CHECK(report.overload->by.object == "block");
  CHECK(report.overload->by.of_hand);
  CHECK(report.overload->most == 100.0);
  // The force rises by less than 20 N/mm x 60 mm/s, both fingers alike: 3e-6 N in a nanosecond.
  CHECK(report.overload->force == doctest::Approx(100.0).epsilon(1e-6));
  // A cell without the limit shows that it is the first such instant.
  Pressing free;
  Tool tool = free.cell.robot(free.arm).model->tool();
  tool.max_force = std::numeric_limits<double>::infinity();
  free.cell.set_model(
      free.arm, std::make_shared<const Robot>(free.cell.robot(free.arm).model->with_tool(tool)));
  free.lower(0.06, 2.0);
  free.cell.advance_to(report.overload->t_ns - 1);
  CHECK(free.force() <= 100.0);
  free.cell.advance_to(report.overload->t_ns);
  CHECK(free.force() > 100.0);
}

TEST_CASE("the instant is the same however time is cut") {
  std::vector<std::int64_t> instants;
  for (const std::int64_t slice : {3000 * kMilli, 7 * kMilli, kMilli / 3, std::int64_t{123'457}}) {
    Pressing bench;
    const int motion = bench.lower(0.06, 1.3);
    for (std::int64_t t = slice; bench.cell.is_moving(bench.arm); t += slice)
      bench.cell.advance_to(t);
    REQUIRE(bench.cell.report(motion).overload);
    instants.push_back(bench.cell.report(motion).overload->t_ns);
    instants.push_back(bench.cell.report(motion).end_ns);
  }
  for (std::size_t i = 2; i < instants.size(); ++i) CHECK(instants[i] == instants[i - 2]);
}

TEST_CASE("what is pressed too hard where a motion begins can be moved away, also along a slope") {
  Pressing bench;
  bench.lower(0.06, 2.0);
  bench.cell.advance_to(3000 * kMilli);
  REQUIRE(bench.force() > 100.0);
  VectorXd q = bench.cell.robot(bench.arm).q;
  q[2] -= 0.04;
  q[0] += 0.05;
  const int away = bench.cell.start(bench.arm, motion_to(bench.cell, bench.arm, q, 1.0));
  bench.cell.advance_to(5000 * kMilli);
  CHECK_FALSE(bench.cell.report(away).overload);
  CHECK(bench.cell.report(away).state == MotionState::kReached);
  // Deeper is reported again.
  const int again = bench.lower(0.06, 1.0);
  bench.cell.advance_to(7000 * kMilli);
  CHECK(bench.cell.report(again).overload);
}

TEST_CASE(
    "motions that press less than the hand can stand go on, and robots without a limit always") {
  Random random(5);
  int over = 0, under = 0;
  for (int k = 0; k < 60; ++k) {
    Pressing bench;
    const double by = random.uniform(0.0, 0.06), time = random.uniform(0.5, 3.0);
    const int motion = bench.lower(by, time);
    double most = 0.0;
    while (bench.cell.is_moving(bench.arm)) {
      bench.cell.advance_to(bench.cell.now_ns() + 10 * kMilli);
      most = std::max(most, bench.force());
    }
    const bool told = bench.cell.report(motion).overload.has_value();
    CHECK(told == (most > 100.0));
    ++(told ? over : under);
  }
  CHECK(over > 5);
  CHECK(under > 5);
}

namespace {

// The first link of an arm rotates into a post; its gripper has this limit.
struct Elbow {
  Cell cell;
  int arm = 0;

  explicit Elbow(double max_force) {
    Tool tool = parallel_gripper(0.06, 0.05);
    tool.max_force = max_force;
    arm = cell.add_robot(std::make_shared<const Robot>(make_robot("planar3")->with_tool(tool)));
    VectorXd q(3);
    q << 0.0, 1.5, 0.0;
    cell.set_joints(arm, q);
    Object post{.name = "post",
                .shape = Cylinder{0.02, 0.3},
                .friction = 0.0,
                .stiffness = 1e4,
                .fixed = true};
    post.T_world_obj = make_translation({0.25, 0.1, 0.0});
    cell.insert(post);
  }
  int turn(double by) {
    VectorXd q = cell.robot(arm).q;
    q[0] += by;
    return cell.start(arm, motion_to(cell, arm, q, 3.0));
  }
  [[nodiscard]] double force() const { return cell.contact_wrench(arm).head<3>().norm(); }
};

}  // namespace

TEST_CASE("a link that presses harder than the gripper can stand stops the motion too") {
  Elbow bench(40.0);
  const int motion = bench.turn(0.7);
  bench.cell.advance_to(4000 * kMilli);
  const MotionReport& report = bench.cell.report(motion);
  REQUIRE(report.overload);
  CHECK_FALSE(report.overload->by.of_hand);
  CHECK(report.overload->by.object == "post");
  CHECK(report.overload->by.frame == 1);
  CHECK(report.overload->force == doctest::Approx(40.0).epsilon(1e-5));
  Elbow free(std::numeric_limits<double>::infinity());
  free.turn(0.7);
  free.cell.advance_to(report.overload->t_ns - 1);
  CHECK(free.force() <= 40.0);
  free.cell.advance_to(report.overload->t_ns);
  CHECK(free.force() > 40.0);
  // It may be moved away from there.
  const int away = bench.turn(-0.5);
  bench.cell.advance_to(8000 * kMilli);
  CHECK_FALSE(bench.cell.report(away).overload);
  CHECK(bench.force() == 0.0);
  // Less than it can stand goes on.
  Elbow strong(1e6);
  const int through = strong.turn(0.7);
  strong.cell.advance_to(4000 * kMilli);
  CHECK_FALSE(strong.cell.report(through).overload);
}

namespace {

// An arm with a Barrett hand that holds a ball between its fingers.
struct Holding {
  Cell cell{World(0.0)};
  int arm = 0;
  int hand = 0;

  explicit Holding(double mass, double friction, double force) {
    arm = cell.add_robot(make_robot("pa10"));
    VectorXd q = VectorXd::Zero(cell.robot(arm).model->n());
    q[1] = 0.6;
    q[3] = 1.2;
    q[5] = std::numbers::pi - 1.8;  // the tool points down
    cell.set_joints(arm, q);
    hand = cell.add_hand(arm, make_barrett_robots("hand"));
    Object ball{.name = "ball", .shape = Sphere{0.035}, .mass = mass, .friction = friction};
    ball.T_world_obj = cell.T_world_tool(arm);
    cell.insert(ball);
    for (int i = 0; i < 3; ++i) {
      const int finger = cell.robot(hand).fingers[static_cast<std::size_t>(i)];
      VectorXd bends = cell.robot(hand).q;
      bends[i + 1] = close_finger(cell, finger, force).bend;
      cell.start(finger, motion_to(cell, finger, finger_joints(i, bends), {}));
    }
    while (const auto next = cell.next_event()) cell.advance_to(*next);
    (void)cell.take_events();
  }
  int swing(double by, double time) {
    VectorXd q = cell.robot(arm).q;
    q[0] += by;
    return cell.start(arm, motion_to(cell, arm, q, time));
  }
};

}  // namespace

TEST_CASE("the inertia of what fingers hold counts: m (a - g) has to be carried by friction") {
  Holding bench(0.3, 0.6, 6.0);
  REQUIRE(bench.cell.robot(bench.arm).held == "ball");
  CHECK(carried_in_motion(bench.cell, bench.arm) == 1.0);
  const double at_rest =
      carried_part(bench.cell, bench.arm, finger_contacts(bench.cell, bench.hand), "ball");
  REQUIRE(at_rest > 1.0);
  // In a slow motion the ball stays held.
  const int slow = bench.swing(0.5, 4.0);
  bench.cell.advance_to(bench.cell.now_ns() + 4500 * kMilli);
  CHECK(bench.cell.report(slow).state == MotionState::kReached);
  CHECK(bench.cell.robot(bench.arm).held == "ball");
  CHECK(bench.cell.take_events().size() == 1);
  // So fast that friction does not do: the quintic law has a highest acceleration of 5.77 D / T^2.
  const double radius = bench.cell.T_world_tool(bench.arm).translation().head<2>().norm();
  const double time = std::sqrt(5.77 * 1.0 * radius / (6.0 * 9.81 * at_rest));
  const std::int64_t begin = bench.cell.now_ns();
  const int fast = bench.swing(-1.0, time);
  bench.cell.advance_to(begin + 3000 * kMilli);
  CHECK(bench.cell.report(fast).state == MotionState::kReached);
  CHECK(bench.cell.robot(bench.arm).held.empty());
  bool slipped = false;
  for (const CellEvent& each : bench.cell.take_events()) {
    if (each.kind != CellEventKind::kSlipped) continue;
    slipped = true;
    CHECK(each.moving);
    CHECK(each.object == "ball");
    CHECK(each.carried < 1.0);
    CHECK(each.carried > 0.999);  // the first instant
    CHECK(each.t_ns > begin);
    CHECK(each.t_ns < bench.cell.report(fast).end_ns);
  }
  CHECK(slipped);
  CHECK(bench.cell.world().resting_on("ball") == "floor");
}

TEST_CASE("when it slips does not depend on how time is cut") {
  std::vector<std::int64_t> instants;
  for (const std::int64_t slice : {3000 * kMilli, 3 * kMilli, std::int64_t{777'777}}) {
    Holding bench(0.3, 0.6, 6.0);
    const std::int64_t begin = bench.cell.now_ns();
    bench.swing(-1.0, 0.35);
    for (std::int64_t t = begin + slice; bench.cell.is_moving(bench.arm); t += slice)
      bench.cell.advance_to(t);
    for (const CellEvent& each : bench.cell.take_events()) {
      if (each.kind == CellEventKind::kSlipped) instants.push_back(each.t_ns - begin);
    }
  }
  REQUIRE(instants.size() == 3);
  CHECK(instants[0] == instants[1]);
  CHECK(instants[0] == instants[2]);
}
