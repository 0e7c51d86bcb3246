#include "armlet/control/make_move.hpp"

#include <doctest/doctest.h>

#include <array>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "armlet/trajectory/velocity.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

VectorXd joints_between(Random& random, const Robot& robot, double margin) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const double width = robot.upper()[i] - robot.lower()[i];
    q[i] = robot.lower()[i] + (margin + (1.0 - 2.0 * margin) * random.uniform()) * width;
  }
  return q;
}

bool same_bits(const Trajectory& a, const Trajectory& b) {
  if (a.n() != b.n() || a.duration() != b.duration()) return false;
  for (double t = 0.0; t <= a.duration(); t += 0.01) {
    for (int i = 0; i < a.n(); ++i) {
      if (a.value(i, t) != b.value(i, t)) return false;
    }
  }
  return true;
}

// A SCARA with its arm to the right, and the joint values to the left.
struct Scara {
  std::shared_ptr<const Robot> robot = make_robot("scara");
  Cell cell;
  VectorXd right = robot->home(), left = robot->home();
  Scara() {
    cell.add_robot(robot, "arm");
    right[0] = -1.0;
    left[0] = 1.0;
    right[1] = left[1] = 0.6;
    cell.set_joints(0, right);
  }
  void add_wall() {
    Object wall;
    wall.name = "wall";
    wall.shape = Box{{0.2, 0.02, 1.0}};
    wall.fixed = true;
    wall.T_world_obj.translation() = Eigen::Vector3d(0.65, 0.0, 0.5);
    cell.insert(std::move(wall));
  }
};

template <class Why>
Why why_of(const MoveReport& report) {
  REQUIRE(report.refusal);
  REQUIRE(std::holds_alternative<Why>(*report.refusal));
  CHECK(report.motion == -1);
  return std::get<Why>(*report.refusal);
}

}  // namespace

TEST_CASE("a checked move runs the motion of its planner and ends at the target") {
  Random random(0x270);
  for (const char* name : {"scara", "puma560", "ur5"}) {
    const auto robot = make_robot(name);
    for (int k = 0; k < 12; ++k) {
      Cell cell;
      cell.add_robot(robot, "arm");
      const VectorXd q0 = cell.robot(0).q, q1 = joints_between(random, *robot, 0.2);
      const std::string planner = k % 2 == 0 ? "Syn" : "Trap";
      const double speed = 0.2 + 0.8 * random.uniform();
      const MoveReport report =
          make_move(cell, {}, {.target = JointTarget{q1}, .planner = planner, .speed = speed});
      INFO(name, " ", k, ": ", to_text(cell, report));
      REQUIRE(report.ok());
      CHECK(to_text(cell, report).empty());
      const MotionPlan plan =
          plan_joint_move({}, *robot, {.q0 = q0, .q1 = q1, .planner = planner, .speed = speed});
      CHECK(same_bits(*report.planned.motion, *plan.trajectory));
      const double straight =
          (forward(*robot, q1).translation() - forward(*robot, q0).translation()).norm();
      CHECK(report.planned.length == straight);
      cell.advance_to(cell.report(report.motion).end_ns);
      CHECK(cell.robot(0).q == q1);
    }
  }
}

TEST_CASE("a pose in space is reached, and a position with what orientation the arm keeps") {
  Random random(0x271);
  const auto robot = make_robot("puma560");
  for (int k = 0; k < 20; ++k) {
    Cell cell;
    cell.add_robot(robot);
    const Eigen::Isometry3d T = forward(*robot, joints_between(random, *robot, 0.25));
    const bool whole = k % 2 == 0;
    const MoveReport report =
        make_move(cell, {}, {.target = PoseTarget{{.T_world_tool = T, .has_orientation = whole}}});
    INFO(k, ": ", to_text(cell, report));
    REQUIRE(report.ok());
    cell.advance_to(cell.report(report.motion).end_ns);
    const Eigen::Isometry3d reached = cell.T_world_tool(0);
    CHECK((reached.translation() - T.translation()).norm() < 1e-6);  // tolerance of solve_ik
    if (whole) CHECK((reached.linear() - T.linear()).norm() < 1e-5);
  }
}

TEST_CASE("a refused move says why and leaves the cell as it is") {
  Random random(0x272);
  Scara scara;
  scara.add_wall();
  const Eigen::Isometry3d T_far = Eigen::Isometry3d(Eigen::Translation3d(5.0, 0.0, 0.0));
  const MovePolicies strict{.collisions = CollisionCheck::kError};
  const VectorXd outside = VectorXd::Constant(4, 100.0);
  const std::vector<MoveCommand> commands = {
      {.target = JointTarget{scara.left}, .policies = strict},
      {.target = JointTarget{outside}},
      {.target = JointTarget{VectorXd::Zero(3)}},
      {.target = JointTarget{scara.left}, .planner = "Sin"},
      {.target = JointTarget{scara.left}, .time = 0.01},
      {.target = JointTarget{scara.left}, .time = -1.0},
      {.target = JointTarget{scara.left}, .speed = 1.5},
      {.target = JointTarget{scara.left}, .accel = 0.0},
      {.target = JointTarget{scara.left}, .time = 5.0, .time_left = 4.0},
      {.target = JointTarget{scara.left}, .time_left = 0.01},
      {.target = PoseTarget{{T_far}}},
      {.target = LineTarget{{T_far}}},
      {.target = LineTarget{{T_far}, {}, -1.0}},
      {.target = CurveTarget{{{T_far}}}},
      {.target = PathTarget{{{.pose = {T_far}}}}},
      {.target = GivenMotion{Trajectory::at_rest(scara.left, 1.0)}},
  };
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const MoveReport report = make_move(scara.cell, {}, commands[k]);
    INFO(k);
    CHECK_FALSE(report.ok());
    CHECK(report.motion == -1);
    CHECK(to_text(scara.cell, report).size() > 20);
    CHECK_FALSE(scara.cell.is_moving(0));
    CHECK(scara.cell.robot(0).q == scara.right);
    CHECK(scara.cell.robot(0).motion_id == -1);
    CHECK(scara.cell.take_events().empty());
  }
}

TEST_CASE("a pose out of reach is refused with its distance from the reach") {
  Scara scara;
  const double reach = 0.7;  // m, the two links of this arm: 0.4 m and 0.3 m
  const double z = scara.cell.T_world_tool(0).translation().z();
  for (const double x : {0.8, 1.0, 3.0}) {
    const Eigen::Isometry3d T(Eigen::Translation3d(x, 0.0, z));
    const MoveReport report = make_move(
        scara.cell, {}, {.target = PoseTarget{{.T_world_tool = T, .has_orientation = false}}});
    const auto why = why_of<refused::Unreachable>(report);
    CHECK(why.ik.diagnosis.distance == doctest::Approx(x - reach).epsilon(1e-6));
  }
}

TEST_CASE("a collision is reported, refused, or avoided") {
  Scara scara;
  scara.add_wall();
  MoveCommand command{.target = JointTarget{scara.left}};
  command.policies.collisions = CollisionCheck::kError;
  const MoveReport refused = make_move(scara.cell, {}, command);
  const auto why = why_of<refused::Collides>(refused);
  CHECK(why.met.other.object == "wall");
  CHECK(why.met.t > 0.0);
  CHECK(to_text(scara.cell, refused).find("\"wall\"") != std::string::npos);

  command.policies.collisions = CollisionCheck::kIgnore;
  CHECK(plan_move(scara.cell, {}, command).collisions.certain.empty());

  if (can_search_ways()) {
    command.policies.avoid = true;
    const MoveReport around = plan_move(scara.cell, {}, command);
    REQUIRE(around.ok());
    CHECK(around.around);
    CHECK(around.planned.motion->end() == scara.left);
    CHECK(around.planned.times.size() == around.planned.T_world_targets.size());
    CHECK(find_collisions(scara.cell, 0, *around.planned.motion).empty());
    command.policies.avoid = false;
  }

  command.policies.collisions = CollisionCheck::kReport;
  const MoveReport reported = make_move(scara.cell, {}, command);
  REQUIRE(reported.ok());
  REQUIRE_FALSE(reported.collisions.certain.empty());
  CHECK(reported.collisions.certain[0].other.object == "wall");
  CHECK(scara.cell.is_moving(0));
}

TEST_CASE("a motion that a motor cannot drive is refused, or made slower") {
  // Universal Robots, UR5 service manual: 150 N m at the shoulder and the elbow, 28 N m at the wrist.
  const auto heavy = std::make_shared<const Robot>(make_robot("ur5")->with_payload({.mass = 9.0}));
  Cell cell;
  cell.add_robot(heavy, "arm");
  VectorXd q0 = VectorXd::Zero(6), q1 = q0;
  q0[1] = -2.2;
  q1[1] = -0.9;
  cell.set_joints(0, q0);
  MoveCommand command{.target = JointTarget{q1}};
  command.policies.torques = TorqueCheck::kIgnore;
  const MoveReport ignored = plan_move(cell, {}, command);
  REQUIRE(ignored.ok());
  const MotionForces forces = motion_forces(*heavy, *ignored.planned.motion);
  REQUIRE(forces.slower > 1.0);
  REQUIRE(std::isfinite(forces.slower));

  command.policies.torques = TorqueCheck::kError;
  const MoveReport refused = make_move(cell, {}, command);
  why_of<refused::TorqueExceeded>(refused);
  REQUIRE(refused.torques.forces);
  const PeakForce& peak =
      refused.torques.forces->peaks[static_cast<std::size_t>(refused.torques.forces->nearest)];
  CHECK(peak.limit == (refused.torques.forces->nearest < 3 ? 150.0 : 28.0));
  CHECK(std::abs(peak.force) > peak.limit);
  CHECK_FALSE(cell.is_moving(0));

  command.policies.torques = TorqueCheck::kReport;
  CHECK(plan_move(cell, {}, command).torques.is_beyond());

  command.policies.torques = TorqueCheck::kLimit;
  const MoveReport slower = make_move(cell, {}, command);
  REQUIRE(slower.ok());
  CHECK(slower.planned.motion->duration() ==
        doctest::Approx(slower.torques.slower * ignored.planned.motion->duration()));
  const MotionForces after = motion_forces(*heavy, *slower.planned.motion);
  CHECK(after.slower <= 1.0 + 1e-6);  // the search for the factor ends within 1e-6
  CHECK(cell.is_moving(0));
}

TEST_CASE("limits of the joints are kept, widened or clamped as the policy says") {
  Scara scara;
  VectorXd q = scara.left;
  q[0] = scara.robot->upper()[0] + 0.25;
  MoveCommand command{.target = JointTarget{q}};
  const auto refused = plan_move(scara.cell, {}, command);
  const auto why = why_of<refused::OutsideLimits>(refused);
  CHECK(why.violation.joint == 0);
  CHECK(why.violation.excess() == doctest::Approx(0.25));

  command.policies.limits = LimitCheck::kClamp;
  const MoveReport clamped = plan_move(scara.cell, {}, command);
  REQUIRE(clamped.ok());
  CHECK(clamped.planned.motion->end()[0] == scara.robot->upper()[0]);
  REQUIRE(clamped.limits.clamped.size() == 1);
  CHECK(clamped.limits.excess.joint == 0);
  CHECK(clamped.limits.excess.by == doctest::Approx(0.25));

  command.policies.limits = LimitCheck::kWarn;
  const MoveReport beyond = plan_move(scara.cell, {}, command);
  REQUIRE(beyond.ok());
  CHECK(beyond.planned.motion->end() == q);
  REQUIRE(beyond.limits.beyond.size() == 1);
  CHECK(beyond.limits.excess.by == doctest::Approx(0.25));
}

TEST_CASE("a time that is too short is refused, lengthened or kept as the policy says") {
  Scara scara;
  MoveCommand command{.target = JointTarget{scara.left}, .time = 0.1};
  const double least = why_of<TooFast>(plan_move(scara.cell, {}, command)).least_time;
  CHECK(least > 0.1);
  command.policies.limits = LimitCheck::kClamp;
  const MoveReport longer = plan_move(scara.cell, {}, command);
  REQUIRE(longer.ok());
  CHECK(longer.planned.motion->duration() == doctest::Approx(least));
  CHECK(longer.limits.lengthened.size() == 1);
  command.policies = {.report_too_fast = true};
  const MoveReport kept = plan_move(scara.cell, {}, command);
  REQUIRE(kept.ok());
  CHECK(kept.planned.motion->duration() == doctest::Approx(0.1));
  CHECK(kept.limits.too_fast.size() == 1);
}

TEST_CASE("planning changes nothing, and the move that follows is the planned one") {
  Scara scara;
  const Eigen::Isometry3d T = forward(*scara.robot, scara.left);
  const Eigen::Isometry3d T_up = Eigen::Translation3d(0.0, 0.0, 0.05) * T;
  const VectorXd q_up = scara.right;
  const std::vector<MoveTarget> targets = {
      JointTarget{scara.left}, PoseTarget{{T}}, LineTarget{{T}}, CurveTarget{{{T_up}, {T}}},
      PathTarget{{{.pose = {T_up}, .blend = 0.02}, {.pose = {T}}}}};
  for (std::size_t k = 0; k < targets.size(); ++k) {
    scara.cell.set_joints(0, scara.right);
    const MoveCommand command{.target = targets[k], .policies = {.limits = LimitCheck::kWarn}};
    const MoveReport planned = plan_move(scara.cell, {}, command);
    INFO(k, ": ", to_text(scara.cell, planned));
    REQUIRE(planned.ok());
    CHECK(planned.motion == -1);
    CHECK_FALSE(scara.cell.is_moving(0));
    const MoveReport made = make_move(scara.cell, {}, command);
    REQUIRE(made.ok());
    CHECK(same_bits(*planned.planned.motion, *made.planned.motion));
    CHECK(made.planned.times.size() == (k < 3 ? 0 : 2));
    scara.cell.advance_to(scara.cell.report(made.motion).end_ns);
    CHECK((scara.cell.T_world_tool(0).translation() - T.translation()).norm() < 1e-5);
  }
}

TEST_CASE("a robot that moves is busy until its motion has ended") {
  Scara scara;
  const MoveReport first = make_move(scara.cell, {}, {.target = JointTarget{scara.left}});
  REQUIRE(first.ok());
  CHECK(moving_part(scara.cell, 0) == 0);
  CHECK(why_of<refused::Busy>(make_move(scara.cell, {}, {.target = JointTarget{scara.right}}))
            .robot == 0);
  scara.cell.advance_to(scara.cell.report(first.motion).end_ns);
  CHECK_FALSE(moving_part(scara.cell, 0));
  CHECK(make_move(scara.cell, {}, {.target = JointTarget{scara.right}}).ok());
}

TEST_CASE("a move after a velocity command begins with its speed") {
  Scara scara;
  const CellRobot& arm = scara.cell.robot(0);
  constexpr std::int64_t kHold = 200'000'000;
  const VectorXd rates = Eigen::Vector4d(0.4, 0.0, 0.0, 0.0);
  const VelocityPlan plan =
      plan_joint_velocity(*arm.model, {arm.q, arm.qd, arm.qdd, to_seconds(kHold)}, rates);
  scara.cell.drive(0, plan.motion.value(), kHold);
  scara.cell.advance_to(kHold);
  const double speed = arm.qd[0];
  REQUIRE(speed > 0.1);
  const MoveReport report = make_move(scara.cell, {}, {.target = JointTarget{scara.left}});
  REQUIRE(report.ok());
  CHECK(report.planned.motion->value(0, 0.0, 1) == doctest::Approx(speed));
  scara.cell.advance_to(scara.cell.report(report.motion).end_ns);
  CHECK(arm.q == scara.left);
}

TEST_CASE("a given motion is checked unless its caller has verified it") {
  Scara scara;
  const MotionPlan plan =
      plan_joint_move({}, *scara.robot, {.q0 = scara.right, .q1 = scara.left, .time = 3.0});
  const Trajectory fast = plan.trajectory->stretched(0.05);
  why_of<TooFast>(plan_move(scara.cell, {}, {.target = GivenMotion{fast, "Syn"}}));
  CHECK(plan_move(scara.cell, {}, {.target = GivenMotion{fast, "Syn", true}}).ok());
  const MoveReport report = make_move(scara.cell, {}, {.target = GivenMotion{*plan.trajectory}});
  REQUIRE(report.ok());
  CHECK(same_bits(*report.planned.motion, *plan.trajectory));
  scara.cell.advance_to(to_ns(3.0));
  const auto why = why_of<refused::StartsElsewhere>(
      plan_move(scara.cell, {}, {.target = GivenMotion{*plan.trajectory}}));
  CHECK(why.joint == 0);
  CHECK(why.stands - why.starts == doctest::Approx(2.0));
}

TEST_CASE("a search around obstacles leads to joint values only" *
          doctest::skip(!can_search_ways())) {
  Scara scara;
  scara.add_wall();
  const MoveReport report =
      plan_around(scara.cell, {.target = JointTarget{scara.left}}, {.clearance = 0.01});
  REQUIRE(report.ok());
  CHECK(report.planned.motion->end() == scara.left);
  CHECK_FALSE(scara.cell.is_moving(0));
  CHECK_THROWS_AS(plan_around(scara.cell, {.target = PoseTarget{}}, {}), ArgumentError);
}

}  // namespace armlet
