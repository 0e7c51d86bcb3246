#include "armlet/cell/fingers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/collision/solid.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/mechanism_forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// An arm that stands still, with a hand with fingers on it.
struct Grasping {
  Cell cell{World(0.0)};
  int arm = 0;
  int hand = 0;

  explicit Grasping(const char* name = "pa10") {
    arm = cell.add_robot(make_robot(name));
    VectorXd q = VectorXd::Zero(cell.robot(arm).model->n());
    q[1] = 0.6;
    q[3] = 1.2;
    cell.set_joints(arm, q);
    hand = cell.add_hand(arm, make_barrett_robots("hand"));
  }

  // An object between the fingers, rotated as the hand with fingers is, `out` m along the tool from
  // its point.
  void put(Shape shape, double mass, double friction, double out = 0.0) {
    Object object{.name = "thing", .shape = shape, .mass = mass, .friction = friction};
    object.T_world_obj = cell.T_world_tool(arm) * make_translation({0.0, 0.0, out});
    cell.insert(object);
  }

  [[nodiscard]] int finger(int i) const {
    return cell.robot(hand).fingers[static_cast<std::size_t>(i)];
  }

  int move(int robot, const VectorXd& to) {
    const PlannerSet planners;
    const CellRobot& state = cell.robot(robot);
    MotionPlan plan = plan_joint_move(planners, *state.model,
                                      {.q0 = state.q, .q1 = to, .planner = "Syn", .speed = 1.0});
    REQUIRE(plan.trajectory);
    return cell.start(robot, *std::move(plan.trajectory));
  }

  void bend(int i, double bend) {
    VectorXd q = cell.robot(hand).q;
    q[i + 1] = bend;
    move(finger(i), finger_joints(i, q));
  }

  void wait() {
    while (const auto next = cell.next_event()) cell.advance_to(*next);
  }

  void close(double force) {
    for (int i = 0; i < 3; ++i) bend(i, close_finger(cell, finger(i), force).bend);
    wait();
  }
  void open() {
    for (int i = 0; i < 3; ++i) bend(i, 0.0);
    wait();
  }
};

// The least distance of a finger from the thing when it is bent that far.
double finger_gap_at(const Grasping& bench, int i, double bend) {
  const CellRobot& finger = bench.cell.robot(bench.finger(i));
  VectorXd q = bench.cell.robot(bench.hand).q;
  q[i + 1] = bend;
  const auto frames = link_frames(*finger.model, finger_joints(i, q));
  const Object& object = bench.cell.world().at("thing");
  Solid thing = solid_of(object.shape);
  thing.T = object.T_world_obj;
  double least = 1e9;
  for (const ArmSolid& each : finger.model->derived<ArmSolids>().solids()) {
    Solid link = each.solid;
    link.T = bench.cell.T_world_flange(bench.arm) *
             frames[static_cast<std::size_t>(each.frame - 1)] * each.solid.T;
    least = std::min(least, gap_between(link, thing).distance);
  }
  return least;
}

Shape some_shape(Random& random) {
  const double r = random.uniform(0.02, 0.035);
  switch (random.below(3)) {
    case 0:
      return Sphere{r};
    case 1:
      return Cylinder{r, random.uniform(0.03, 0.08)};
    default:
      return Box{{1.4 * r, 1.6 * r, 1.5 * r}};
  }
}

}  // namespace

TEST_CASE("a hand with fingers moves with the flange") {
  Grasping bench;
  CHECK(bench.cell.robot_count() == 5);
  CHECK(bench.cell.hand_on(bench.arm) == bench.hand);
  const Isometry3d T = bench.cell.T_world_flange(bench.arm);
  CHECK((bench.cell.T_world_tool(bench.hand).matrix() - bench.cell.T_world_tool(bench.arm).matrix())
            .norm() < 1e-12);
  CHECK((bench.cell.T_world_tool(bench.arm).translation() - T * Vector3d(0, 0, 0.165)).norm() <
        1e-12);
  // The tips are where the tree of links of the Barrett hand has them.
  const Mechanism tree = make_barrett_hand();
  VectorXd q(4);
  q << 0.7, 0.4, 0.9, 1.3;
  bench.cell.set_joints(bench.hand, q);
  for (int i = 0; i < 3; ++i) {
    const std::string tip = "tip" + std::to_string(i + 1);
    const Isometry3d expected = T * tip_pose(tree, q, tree.tip(tip));
    CHECK(
        (bench.cell.T_world_flange(bench.finger(i)).translation() - expected.translation()).norm() <
        1e-12);
  }
}

TEST_CASE("an arm has one hand with fingers, and that has none") {
  Grasping bench;
  CHECK_THROWS_AS((void)bench.cell.add_hand(bench.arm, make_barrett_robots("other")),
                  ArgumentError);
  CHECK_THROWS_AS((void)bench.cell.add_hand(bench.hand, make_barrett_robots("other")),
                  ArgumentError);
  CHECK_THROWS_AS((void)finger_contacts(bench.cell, bench.arm), ArgumentError);
  CHECK_THROWS_AS((void)finger_force(bench.cell, bench.hand), ArgumentError);
  const int second = bench.cell.add_robot(make_robot("puma560"));
  CHECK_THROWS_AS((void)bench.cell.add_hand(second, make_barrett_robots("hand")), ArgumentError);
  CHECK(bench.cell.robot_count() == 6);
}

TEST_CASE("joints of palm and fingers follow each other") {
  Grasping bench;
  bench.bend(1, 0.8);
  bench.cell.advance_to(bench.cell.now_ns() + 100'000'000);
  CHECK(bench.cell.robot(bench.hand).q[2] == bench.cell.robot(bench.finger(1)).q[1]);
  CHECK(bench.cell.robot(bench.hand).q[2] > 0.0);
  CHECK(bench.cell.robot(bench.finger(1)).q[2] ==
        doctest::Approx(bench.cell.robot(bench.hand).q[2] / 3.0));
  bench.wait();
  VectorXd q(4);
  q << 1.0, 0.2, 0.3, 0.4;
  bench.move(bench.hand, q);
  bench.wait();
  for (int i = 0; i < 3; ++i)
    CHECK((bench.cell.robot(bench.finger(i)).q - finger_joints(i, q)).norm() == 0.0);
}

TEST_CASE("a finger stops at the first contact, found without samples") {
  Random random(67);
  int touched = 0;
  for (int round = 0; round < 60; ++round) {
    Grasping bench;
    bench.put(some_shape(random), 0.1, 0.5, random.uniform(-0.01, 0.03));
    for (int i = 0; i < 3; ++i) {
      const Closing closing = close_finger(bench.cell, bench.finger(i), 4.0);
      CAPTURE(round);
      CAPTURE(i);
      // Nothing before it is touched, as many samples say.
      for (int k = 0; k <= 2000; ++k) {
        const double bend = closing.touch * k / 2000.0;
        if (finger_gap_at(bench, i, bend) < -1e-9) FAIL("passed a contact at " << bend);
      }
      if (closing.touch >= deg_to_rad(140.0)) continue;
      ++touched;
      CHECK(std::abs(finger_gap_at(bench, i, closing.touch)) <= 1.1e-7);
      CHECK(closing.bend > closing.touch);
      bench.bend(i, closing.bend);
      bench.wait();
      if (closing.bend >= deg_to_rad(140.0)) continue;  // it passes by, and never presses so hard
      // Depths are right to 1e-7 m, which is 0.005 N.
      CHECK(finger_force(bench.cell, bench.finger(i)) == doctest::Approx(4.0).epsilon(0.002));
      bench.bend(i, 0.0);
      bench.wait();
    }
  }
  CHECK(touched > 120);
}

TEST_CASE("the force is the stiffness times the depth, worked out by hand") {
  Grasping bench;
  bench.put(Sphere{0.03}, 0.1, 0.5);
  const double touch = close_finger(bench.cell, bench.finger(2), 1.0).touch;
  VectorXd q = bench.cell.robot(bench.hand).q;
  q[3] = touch + 0.002;
  bench.cell.set_joints(bench.hand, q);
  const double depth = -finger_gap_at(bench, 2, q[3]);
  CHECK(depth > 1e-5);
  CHECK(finger_force(bench.cell, bench.finger(2)) == doctest::Approx(5e4 * depth).epsilon(1e-9));
  // The reaction acts on the hand with fingers, and on its arm.
  const Vector6d wrench = bench.cell.contact_wrench(bench.hand);
  CHECK(wrench.head<3>().norm() == doctest::Approx(5e4 * depth).epsilon(1e-9));
  CHECK((bench.cell.contact_wrench(bench.arm) - wrench).norm() < 1e-12);
  const FingerContact contact = finger_contacts(bench.cell, bench.hand).front();
  CHECK(contact.finger == 2);
  // Towards the middle of the sphere.
  const Vector3d centre = bench.cell.world().at("thing").T_world_obj.translation();
  CHECK((centre - contact.p).normalized().dot(contact.inward) == doctest::Approx(1.0));
}

TEST_CASE("what friction carries is taken and moves with the arm; what it does not stays") {
  for (const double mass : {0.1, 0.5, 5.0}) {
    CAPTURE(mass);
    Grasping bench;
    bench.put(Sphere{0.03}, mass, 0.6);
    bench.close(8.0);
    const auto contacts = finger_contacts(bench.cell, bench.hand);
    CHECK(contacts.size() >= 3);
    const double part = carried_part(bench.cell, bench.arm, contacts, "thing");
    const bool holds = !bench.cell.robot(bench.arm).held.empty();
    CHECK(holds == (part >= 1.0));
    CHECK(holds == (mass < 2.0));
    // No more can be carried than all fingers press with times friction and 1.
    CHECK(part * mass * 9.81 <= 24.0 * (1.0 + 0.6) + 1e-6);
    const Isometry3d before =
        bench.cell.T_world_tool(bench.arm).inverse() * bench.cell.world().at("thing").T_world_obj;
    VectorXd q = bench.cell.robot(bench.arm).q;
    q[0] += 0.4;
    bench.move(bench.arm, q);
    bench.wait();
    const Isometry3d after =
        bench.cell.T_world_tool(bench.arm).inverse() * bench.cell.world().at("thing").T_world_obj;
    CHECK(((before.matrix() - after.matrix()).norm() < 1e-12) == holds);
    CHECK((bench.cell.robot(bench.arm).loaded != bench.cell.robot(bench.arm).model) == holds);
  }
}

TEST_CASE("a held thing falls where the fingers open, and where the arm rotates too far") {
  Grasping bench;
  bench.put(Sphere{0.03}, 0.2, 0.6);
  bench.close(6.0);
  REQUIRE(bench.cell.robot(bench.arm).held == "thing");
  bench.open();
  CHECK(bench.cell.robot(bench.arm).held.empty());
  CHECK(bench.cell.world().at("thing").T_world_obj.translation().z() == doctest::Approx(0.03));
}

TEST_CASE("a motion of the arm at whose end the fingers do not carry it drops it") {
  // Fingers pull a plate without friction up against nothing: it is carried while it lies on them.
  Random random(3);
  int slipped = 0;
  for (int round = 0; round < 30; ++round) {
    Grasping bench;
    bench.put(Sphere{0.03}, random.uniform(0.1, 1.5), random.uniform(0.05, 0.5));
    bench.close(6.0);
    if (bench.cell.robot(bench.arm).held.empty()) continue;
    bench.cell.take_events();
    VectorXd q = bench.cell.robot(bench.arm).q;
    q[1] += random.uniform(-1.2, 0.5);
    q[4] += random.uniform(-1.5, 1.5);
    q = q.cwiseMax(bench.cell.robot(bench.arm).model->lower())
            .cwiseMin(bench.cell.robot(bench.arm).model->upper());
    bench.move(bench.arm, q);
    bench.wait();
    const auto contacts = finger_contacts(bench.cell, bench.hand);
    const bool holds = !bench.cell.robot(bench.arm).held.empty();
    CAPTURE(round);
    if (holds) {
      CHECK(carried_part(bench.cell, bench.arm, contacts, "thing") >= 1.0);
      continue;
    }
    ++slipped;
    bool told = false;
    for (const CellEvent& each : bench.cell.take_events()) {
      if (each.kind != CellEventKind::kSlipped) continue;
      told = true;
      CHECK(each.object == "thing");
      CHECK(each.carried < 1.0);
    }
    CHECK(told);
  }
  CHECK(slipped > 0);
}

TEST_CASE("slices of time change nothing") {
  const auto run = [](std::int64_t slice) {
    Grasping bench;
    bench.put(Cylinder{0.028, 0.06}, 0.3, 0.5);
    for (int i = 0; i < 3; ++i) bench.bend(i, close_finger(bench.cell, bench.finger(i), 7.0).bend);
    for (std::int64_t t = 0; t < 1'500'000'000; t += slice) bench.cell.advance_to(t);
    bench.cell.advance_to(1'500'000'000);
    VectorXd q = bench.cell.robot(bench.arm).q;
    q[0] += 0.3;
    bench.move(bench.arm, q);
    for (std::int64_t t = 1'500'000'000; t < 3'000'000'000; t += slice) bench.cell.advance_to(t);
    bench.cell.advance_to(3'000'000'000);
    return bench.cell.world().at("thing").T_world_obj.matrix();
  };
  CHECK(run(1'000'000) == run(7'300'000));
  CHECK(run(1'000'000) == run(1'500'000'000));
}

TEST_CASE("the quality of a grasp is that of its contacts") {
  Grasping bench;
  bench.put(Sphere{0.03}, 0.1, 0.6);
  CHECK(hand_quality(bench.cell, bench.hand, "thing").contacts == 0);
  bench.close(5.0);
  const GraspQuality quality = hand_quality(bench.cell, bench.hand, "thing");
  CHECK(quality.contacts >= 3);
  CHECK(quality.force_closure);
  CHECK(quality.epsilon > 0.0);
  CHECK_THROWS_AS((void)hand_quality(bench.cell, bench.hand, "nothing"), ArgumentError);
}

namespace {

// The smallest gap between two robots, of one finger and another or the palm.
double apart(const Grasping& bench, int a, int b) {
  return distance_between(bench.cell, {.robot = a}, {.robot = b});
}

}  // namespace

TEST_CASE("fingers never come to the palm, however they stand") {
  Grasping bench;
  double least = 1.0;
  for (int spread = 0; spread <= 12; ++spread) {
    for (int bend = 0; bend <= 56; ++bend) {
      VectorXd q = VectorXd::Constant(4, deg_to_rad(2.5 * bend));
      q[0] = deg_to_rad(15.0 * spread);
      bench.cell.set_joints(bench.hand, q);
      const CellRobot& palm = bench.cell.robot(bench.hand);
      const ArmSolid& body = palm.model->derived<ArmSolids>().solids().front();
      Solid cylinder = body.solid;
      cylinder.T = bench.cell.T_world_flange(bench.arm) * body.solid.T;
      for (int i = 0; i < 3; ++i) {
        const CellRobot& finger = bench.cell.robot(bench.finger(i));
        for (const ArmSolid& each : finger.model->derived<ArmSolids>().solids()) {
          Solid link = each.solid;
          link.T = bench.cell.T_world_link(bench.finger(i), each.frame) * each.solid.T;
          least = std::min(least, gap_between(link, cylinder).distance);
        }
      }
    }
  }
  CHECK(least > 3e-4);
}

TEST_CASE("closing stops where fingers touch, and no finger passes another") {
  Random random(144);
  int met = 0, free = 0;
  for (int round = 0; round < 60; ++round) {
    Grasping bench;
    VectorXd q = VectorXd::Zero(4);
    q[0] = random.uniform(0.0, std::numbers::pi);
    for (int i = 1; i < 4; ++i) q[i] = random.uniform(0.0, 0.4);
    bench.cell.set_joints(bench.hand, q);
    const std::vector<Closing> closings = close_hand(bench.cell, bench.hand, 5.0);
    const double end = deg_to_rad(140.0);
    // They bend equally fast, so they are there at the same time.
    double most = 0.0;
    for (int i = 0; i < 3; ++i)
      most = std::max(most, closings[static_cast<std::size_t>(i)].bend - q[i + 1]);
    double least = 1.0;
    for (int k = 0; k <= 400; ++k) {
      VectorXd now = q;
      for (int i = 0; i < 3; ++i) {
        const double bend = closings[static_cast<std::size_t>(i)].bend;
        now[i + 1] = std::min(bend, q[i + 1] + most * k / 400.0);
      }
      bench.cell.set_joints(bench.hand, now);
      for (int i = 0; i < 3; ++i) {
        for (int j = i + 1; j < 3; ++j)
          least = std::min(least, apart(bench, bench.finger(i), bench.finger(j)));
      }
    }
    CAPTURE(round);
    CHECK(least > -1e-8);
    const bool stopped =
        std::ranges::any_of(closings, [&](const Closing& each) { return each.bend < end; });
    CHECK(stopped == (least < 2e-5));
    ++(stopped ? met : free);
  }
  CHECK(met > 10);
  CHECK(free > 10);
}

TEST_CASE("motions of fingers that meet are found, as many samples say") {
  Random random(145);  // of the 160 rounds some begin in an overlap
  int met = 0, free = 0;
  for (int round = 0; round < 160; ++round) {
    Grasping bench;
    const auto some = [&] {
      VectorXd q(4);
      q[0] = random.uniform(0.0, std::numbers::pi);
      for (int i = 1; i < 4; ++i) q[i] = random.uniform(0.0, deg_to_rad(140.0));
      return q;
    };
    const auto least_gap = [&] {
      double least = 1.0;
      for (int i = 0; i < 3; ++i) {
        for (int j = i + 1; j < 3; ++j)
          least = std::min(least, apart(bench, bench.finger(i), bench.finger(j)));
      }
      return least;
    };
    const VectorXd q0 = some(), q1 = some();
    bench.cell.set_joints(bench.hand, q0);
    if (least_gap() < 0.0) continue;  // it may be left
    const MotionPlan plan = plan_joint_move(PlannerSet(), *bench.cell.robot(bench.hand).model,
                                            {.q0 = q0, .q1 = q1, .planner = "Syn", .speed = 1.0});
    REQUIRE(plan.trajectory);
    const auto found = find_collisions(bench.cell, bench.hand, *plan.trajectory);
    double least = 1.0;
    for (int k = 0; k <= 1000; ++k) {
      VectorXd q(4), qd(4), qdd(4);
      plan.trajectory->sample(plan.trajectory->duration() * k / 1000.0, q, qd, qdd);
      bench.cell.set_joints(bench.hand, q);
      least = std::min(least, least_gap());
    }
    CAPTURE(round);
    CAPTURE(least);
    if (least < -1.5e-4) CHECK_FALSE(found.empty());
    if (least > 0.0) CHECK(found.empty());
    for (const CellCollision& each : found) {
      CHECK(bench.cell.robot(each.body.robot).hand == bench.hand);
      CHECK(bench.cell.robot(each.other.robot).hand == bench.hand);
      CHECK(each.depth <= -least + 1e-4);
    }
    ++(found.empty() ? free : met);
  }
  CHECK(met > 10);
  CHECK(free > 10);
}

TEST_CASE("of two fingers that begin at once one is compared with the other") {
  Grasping bench;
  VectorXd q = VectorXd::Zero(4);
  q[0] = 0.5 * std::numbers::pi;
  bench.cell.set_joints(bench.hand, q);
  std::vector<Trajectory> motions;
  for (int i = 0; i < 2; ++i) {
    VectorXd to = q;
    to[i + 1] = deg_to_rad(110.0);
    const CellRobot& finger = bench.cell.robot(bench.finger(i));
    motions.push_back(
        *plan_joint_move(
             PlannerSet(), *finger.model,
             {.q0 = finger.q, .q1 = finger_joints(i, to), .planner = "Syn", .speed = 1.0})
             .trajectory);
  }
  const int first = bench.finger(0), second = bench.finger(1);
  // Alone each passes where the other one is open.
  CHECK(find_collisions(bench.cell, first, motions[0]).empty());
  CHECK(find_collisions(bench.cell, second, motions[1]).empty());
  const MotionBeside one{first, &motions[0]}, other{second, &motions[1]};
  const auto found = find_collisions(bench.cell, first, motions[0], std::span(&other, 1));
  REQUIRE(found.size() == 1);
  CHECK(found[0].other.robot == second);
  CHECK(find_collisions(bench.cell, second, motions[1], std::span(&one, 1)).empty());
  // One that moves already.
  bench.cell.start(first, motions[0]);
  CHECK(find_collisions(bench.cell, second, motions[1]).size() == 1);
}
