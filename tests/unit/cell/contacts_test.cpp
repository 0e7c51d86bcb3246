// Contact forces on a tool: numbers by hand, with a SCARA whose third joint lowers the tool.
#include "armlet/cell/contacts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::int64_t kMs = 1'000'000;

Trajectory probe_move(const Cell& cell, int robot, const VectorXd& q1, double time) {
  const CellRobot& arm = cell.robot(robot);
  MotionPlan plan = plan_joint_move(PlannerSet(), *arm.model,
                                    {.q0 = arm.q, .q1 = q1, .time = time, .enforce_limits = false});
  return *std::move(plan.trajectory);
}

// The tool point of an arm without a gripper; `p` is where it stands, 50 mm below its home.
struct Probe {
  Cell cell;
  int arm;
  Vector3d p;

  Probe()
      : arm(cell.add_robot(
            std::make_shared<const Robot>(make_robot("scara")->with_tool(point_tool(0.0))))) {
    VectorXd q = cell.robot(arm).q;
    q[2] = 0.05;
    cell.set_joints(arm, q);
    p = cell.T_world_tool(arm).translation();
  }

  // A body whose centre is `off` from the tool point.
  void put(const char* name, const Shape& shape, const Vector3d& off, bool fixed = true,
           double tilt = 0.0) {
    Object object{.name = name, .shape = shape, .fixed = fixed};
    object.T_world_obj = pose_from_rpy(p + off, {0.0, tilt, 0.0});
    cell.insert(object);
  }
  int lower(double by, double time = 1.0) {
    VectorXd q = cell.robot(arm).q;
    q[2] += by;
    return cell.start(arm, probe_move(cell, arm, q, time));
  }
  void wait(std::int64_t ms) { cell.advance_to(cell.now_ns() + ms * kMs); }
  [[nodiscard]] double below() const { return p.z() - cell.T_world_tool(arm).translation().z(); }
  [[nodiscard]] Vector3d force() const { return cell.contact_wrench(arm).head<3>(); }
  [[nodiscard]] Vector3d moment() const { return cell.contact_wrench(arm).tail<3>(); }
};

}  // namespace

TEST_CASE("a point on a box: stiffness times depth, and nothing above it") {
  Probe probe;
  probe.put("box", Box{{0.1, 0.1, 0.1}}, {0.0, 0.0, -0.06});
  CHECK(probe.force().isZero(0.0));
  probe.lower(0.012);
  for (int k = 0; k < 10; ++k) {
    probe.wait(100);
    const double depth = probe.below() - 0.010;
    const Vector3d expected(0.0, 0.0, 5e4 * std::max(depth, 0.0));
    CHECK((probe.force() - expected).norm() < 1e-5);
    CHECK(probe.moment().norm() < 1e-9);
  }
  // 2 mm deep it stands; it comes out again.
  CHECK(probe.force().z() == doctest::Approx(100.0).epsilon(1e-9));
  probe.lower(-0.012);
  probe.wait(1000);
  CHECK(probe.force().isZero(0.0));
}

TEST_CASE("a carried ball on a ball, with the stiffness of the one that stands") {
  Probe probe;
  probe.put("held", Sphere{0.02}, Vector3d::Zero(), false);
  Object stands{.name = "stands", .shape = Sphere{0.03}, .stiffness = 2e4};
  stands.T_world_obj = make_translation(probe.p - Vector3d(0.03, 0.0, 0.05));
  probe.cell.insert(stands);
  probe.cell.take(probe.arm, "held");
  // The centres touch at 50 mm apart, 30 mm of them aside: when the held one is 40 mm higher.
  probe.lower(0.011);
  probe.wait(1000);
  // The normal is that of the first touch, from ball to ball; 1 mm down is 0.8 mm along it. The
  // balls overlap along this normal until the centres are 50 mm apart again.
  const Vector3d n(0.6, 0.0, 0.8), apart(0.03, 0.0, 0.039);
  const double along = apart.dot(n);
  const double depth = std::sqrt(along * along - apart.squaredNorm() + 0.0025) - along;
  // A touch begins 0.01 mm before: the direction from centre to centre is off by 2e-4.
  CHECK((probe.force() - 2e4 * depth * n).norm() < 3e-4 * probe.force().norm());
  CHECK((probe.force().normalized() - n).norm() < 3e-4);
}

TEST_CASE("a ball on an inclined plane slides down it: normal force and friction") {
  Probe probe;
  probe.put("ball", Sphere{0.02}, Vector3d::Zero(), false);
  // Its top face passes 30 mm below the ball's centre, measured along the normal.
  const double tilt = 0.4;
  const Vector3d n(std::sin(tilt), 0.0, std::cos(tilt));
  probe.put("ramp", Box{{0.4, 0.4, 0.1}}, -0.08 * n, true, tilt);
  probe.cell.take(probe.arm, "ball");
  probe.lower(0.02);
  probe.wait(600);
  const double s = probe.below();
  const double depth = s * std::cos(tilt) - 0.01;
  REQUIRE(depth > 1e-3);
  // It moves straight down: along the plane downhill, which friction opposes.
  const Vector3d downhill(std::cos(tilt), 0.0, -std::sin(tilt));
  const Vector3d expected = 5e4 * depth * (n - 0.5 * downhill);
  CHECK((probe.force() - expected).norm() < 1e-6 * expected.norm());
  // It acts where the ball is deepest, a radius from the tool point.
  const Vector3d moment = (-0.02 * n).cross(expected);
  CHECK((probe.moment() - moment).norm() < 1e-6 * moment.norm());
  probe.wait(400);
  const double at_rest = probe.below() * std::cos(tilt) - 0.01;
  CHECK((probe.force() - 5e4 * at_rest * n).norm() < 1e-5 * probe.force().norm());
}

TEST_CASE("a box that is dragged over a plane: Coulomb friction, of the smoother one") {
  Probe probe;
  Object held{.name = "held", .shape = Box{{0.04, 0.06, 0.06}}, .friction = 0.2};
  held.T_world_obj = make_translation(probe.p);
  probe.cell.insert(held);
  probe.put("sheet", Plane{{2.0, 2.0}}, {0.0, 0.0, -0.031});
  probe.cell.take(probe.arm, "held");
  probe.lower(0.0015);
  probe.wait(1000);
  const double press = 5e4 * 0.0005;
  CHECK(probe.force().z() == doctest::Approx(press).epsilon(1e-6));
  CHECK(probe.force().head<2>().norm() < 1e-6);
  CHECK(probe.moment().norm() < 1e-6);
  VectorXd q = probe.cell.robot(probe.arm).q;
  q[0] += 0.5;
  probe.cell.start(probe.arm, probe_move(probe.cell, probe.arm, q, 2.0));
  probe.wait(700);
  const CellRobot& arm = probe.cell.robot(probe.arm);
  const Vector3d v = (jacobian(*arm.model, arm.q) * arm.qd).head<3>();
  REQUIRE(v.norm() > 0.01);
  // The middle of the face is 30 mm below the tool point and rotates with it.
  const Vector3d expected = press * Vector3d::UnitZ() - 0.2 * press * v.normalized();
  CHECK((probe.force() - expected).norm() < 1e-5 * press);
  CHECK((probe.moment() - Vector3d(0.0, 0.0, -0.03).cross(expected)).norm() < 1e-6 * press);
}

TEST_CASE("at the edge of a plate the normal stays that of the first touch") {
  Probe probe;
  probe.put("peg", Cylinder{0.01, 0.04}, Vector3d::Zero(), false);
  // The peg overlaps the plate by 1 mm only, and is pressed 5 mm into it: the shortest exit
  // would be aside.
  probe.put("plate", Box{{0.1, 0.1, 0.02}}, {0.059, 0.0, -0.035});
  probe.cell.take(probe.arm, "peg");
  probe.lower(0.010);
  probe.wait(1000);
  CHECK((probe.force() - Vector3d(0.0, 0.0, 5e4 * 0.005)).norm() < 1e-4);
  // The depth along the first normal stays through the next motion; a new touch would have another.
  VectorXd q = probe.cell.robot(probe.arm).q;
  q[3] += 0.4;
  probe.cell.start(probe.arm, probe_move(probe.cell, probe.arm, q, 1.0));
  probe.wait(1000);
  CHECK((probe.force() - Vector3d(0.0, 0.0, 5e4 * 0.005)).norm() < 1e-4);
  // Pulled out and pushed from the side, it has a contact force from the side.
  probe.lower(-0.010);
  probe.wait(1000);
  CHECK(probe.force().isZero(0.0));
}

TEST_CASE("the same force to the last bit for slices of any size and questions at any time") {
  const auto run = [](std::int64_t step_ns, bool asks) {
    Probe probe;
    probe.put("ball", Sphere{0.02}, Vector3d::Zero(), false);
    probe.put("ramp", Box{{0.4, 0.4, 0.1}}, {-0.03, 0.0, -0.08}, true, 0.4);
    probe.put("post", Cylinder{0.03, 0.1}, {0.045, 0.0, -0.08});
    probe.cell.take(probe.arm, "ball");
    std::vector<Vector6d> felt;
    const auto until = [&](std::int64_t t_ns) {
      while (probe.cell.now_ns() < t_ns) {
        probe.cell.advance_to(std::min(t_ns, probe.cell.now_ns() + step_ns));
        if (asks) (void)probe.cell.contact_wrench(probe.arm);
      }
      felt.push_back(probe.cell.contact_wrench(probe.arm));
    };
    probe.lower(0.02);
    until(777'777'777);
    until(1'000'000'000);
    VectorXd q = probe.cell.robot(probe.arm).q;
    q[0] += 0.05;
    q[2] -= 0.008;
    probe.cell.start(probe.arm, probe_move(probe.cell, probe.arm, q, 0.7));
    until(1'234'567'890);
    probe.cell.stop(probe.arm);
    until(1'240'000'000);
    until(2'000'000'000);
    return felt;
  };
  const std::vector<Vector6d> whole = run(10'000'000'000, false);
  CHECK(whole[0].head<3>().norm() > 10.0);
  CHECK(whole[2].head<3>().norm() > 10.0);
  for (const std::int64_t step :
       std::vector<std::int64_t>{17'000'000'000, 1'000'000, 333'333, 7'100'003}) {
    for (const bool asks : {false, true}) {
      const std::vector<Vector6d> sliced = run(step, asks);
      for (std::size_t i = 0; i < whole.size(); ++i) CHECK(sliced[i] == whole[i]);
    }
  }
}

TEST_CASE("no contact force comes from what a gripper holds or is open for") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"));
  const Vector3d p = cell.T_world_tool(arm).translation();
  Object cube{.name = "cube", .shape = Box{{0.04, 0.04, 0.04}}};
  cube.T_world_obj = make_translation(p);
  cell.insert(cube);
  CHECK(cell.contact_wrench(arm).isZero(0.0));
  cell.take(arm, "cube");
  CHECK(cell.contact_wrench(arm).isZero(0.0));
  // Wider than the gripper opens, or fixed, it is pressed.
  Object slab{.name = "slab", .shape = Box{{0.1, 0.1, 0.04}}};
  cell.let_go(arm);
  cell.remove("cube");
  slab.T_world_obj = make_translation(p - Vector3d(0.0, 0.0, 0.019));
  cell.insert(slab);
  CHECK(cell.contact_wrench(arm)[2] == doctest::Approx(50.0).epsilon(1e-6));
}

}  // namespace armlet

TEST_CASE(
    "a link that is pressed into a box: force, moment about the tool point, joint torques by "
    "hand") {
  // Two links of 0.5 m in a plane; the second one rotates into a box beside its middle.
  Cell cell;
  const int arm = cell.add_robot(make_robot("planar2"));
  const Robot& model = *cell.robot(arm).model;
  VectorXd q(2);
  q << 0.0, 0.0;
  cell.set_joints(arm, q);
  const ArmSolid* link = nullptr;
  for (const ArmSolid& each : model.derived<ArmSolids>().solids()) {
    if (each.frame == 1 && !each.still && each.role == LinkShapeRole::kLink) link = &each;
  }
  REQUIRE(link != nullptr);
  // A ball beside the middle of the first link, which rotates into it.
  const Eigen::Isometry3d T = link_frame(model, q, 1) * link->solid.T;
  const double r = 0.02;
  const Vector3d along = T.linear().col(2), p_middle = T.translation();
  const Vector3d up = model.T_world_base().linear().col(2);
  const Vector3d side = up.cross(along).normalized();
  const double thick = link->solid.core == Solid::Core::kBox ? link->solid.half.head<2>().maxCoeff()
                       : link->solid.margin > 0.0            ? link->solid.margin
                                                             : link->solid.half.x();
  Object ball{.name = "ball", .shape = Sphere{r}, .friction = 0.0, .stiffness = 1e4};
  ball.T_world_obj = make_translation(p_middle + (thick + r + 0.002) * side);
  cell.insert(ball);
  CHECK(cell.contact_wrench(arm).isZero(0.0));
  CHECK(cell.contact_forces(arm).isZero(0.0));
  const double sign =
      (up.cross(p_middle - model.T_world_base().translation())).dot(side) > 0 ? 1 : -1;
  VectorXd q1 = q;
  q1[0] += sign * 0.02;
  cell.start(arm, probe_move(cell, arm, q1, 1.0));
  cell.advance_to(1000 * kMs);
  const std::vector<Press> presses = cell.presses(arm);
  REQUIRE(presses.size() == 1);
  CHECK(presses[0].frame == 1);
  CHECK_FALSE(presses[0].of_hand);
  const Vector6d wrench = cell.contact_wrench(arm);
  const Vector3d F = wrench.head<3>();
  // About as deep as the arc is long beyond the gap of 2 mm, along the side.
  const double lever = (p_middle - model.T_world_base().translation()).norm();
  CHECK(F.norm() == doctest::Approx(1e4 * (lever * 0.02 - 0.002)).epsilon(0.02));
  CHECK(F.normalized().dot(-side) > 0.999);
  const Vector3d p_tool = cell.T_world_tool(arm).translation();
  CHECK((Vector3d(wrench.tail<3>()) - (presses[0].p - p_tool).cross(F)).norm() < 1e-9);
  // A force on the first link loads the first joint by its lever, and not the second one.
  const VectorXd tau = cell.contact_forces(arm);
  CHECK(tau[1] == 0.0);
  const Vector3d o = model.T_world_base().translation();
  CHECK(tau[0] == doctest::Approx(up.dot((presses[0].p - o).cross(F))).epsilon(1e-9));
  CHECK(std::abs(tau[0]) > 1.0);
}

TEST_CASE(
    "what is felt does not depend on when it is asked for, of links and hands of random arms") {
  Random random(20261127);
  int felt = 0;
  for (int k = 0; k < 40; ++k) {
    const char* names[] = {"scara", "puma560", "ur5", "pa10"};
    const Robot robot = make_robot(names[k % 4])->with_tool(parallel_gripper(0.06, 0.12));
    const auto model = std::make_shared<const Robot>(robot);
    VectorXd q0(robot.n()), q1(robot.n());
    for (int i = 0; i < robot.n(); ++i) {
      q0[i] = random.uniform(0.5 * robot.lower()[i], 0.5 * robot.upper()[i]);
      q1[i] = random.uniform(0.5 * robot.lower()[i], 0.5 * robot.upper()[i]);
    }
    const auto make = [&] {
      auto cell = std::make_unique<Cell>();
      cell->add_robot(model);
      cell->set_joints(0, q0);
      return cell;
    };
    auto first = make(), second = make();
    for (int b = 0; b < 6; ++b) {
      Object object{.name = "o" + std::to_string(b),
                    .shape = Box{{random.uniform(0.02, 0.2), random.uniform(0.02, 0.2), 0.1}}};
      object.T_world_obj = pose_from_rpy(
          {random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), random.uniform(0.0, 0.8)},
          {random.uniform(-3, 3), random.uniform(-1, 1), random.uniform(-3, 3)});
      first->insert(object);
      second->insert(object);
    }
    for (Cell* each : {first.get(), second.get()}) each->start(0, probe_move(*each, 0, q1, 2.0));
    // One is asked all the time, the other one now and then.
    for (int t = 1; t <= 2000; ++t) {
      first->advance_to(t * kMs);
      const Vector6d often = first->contact_wrench(0);
      if (t % 97 != 0) continue;
      second->advance_to(t * kMs);
      const Vector6d rarely = second->contact_wrench(0);
      CHECK(often == rarely);
      if (!often.isZero(0.0)) ++felt;
    }
  }
  CHECK(felt > 50);
}
