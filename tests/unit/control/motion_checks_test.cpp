#include "armlet/control/motion_checks.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

Trajectory motion_to(const Robot& robot, const VectorXd& q0, const VectorXd& q1) {
  return *plan_joint_move({}, robot, {.q0 = q0, .q1 = q1}).trajectory;
}

VectorXd scara_joints(double shoulder) { return Eigen::Vector4d(shoulder, 0.0, 0.0, 0.0); }

// Two SCARAs that face each other, 1.2 m apart: the stretched arms overlap in the middle.
struct Neighbours {
  Cell cell;
  std::shared_ptr<const Robot> left = make_robot("scara");
  Trajectory into_middle;
  Neighbours() {
    Eigen::Isometry3d T_base = Eigen::Isometry3d(Eigen::Translation3d(1.2, 0.0, 0.0));
    T_base.rotate(Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitZ()));
    cell.add_robot(left, "left");
    cell.add_robot(std::make_shared<const Robot>(left->with_base(T_base)), "right");
    cell.set_joints(0, scara_joints(1.0));
    cell.set_joints(1, scara_joints(0.0));
    into_middle = motion_to(*left, scara_joints(1.0), scara_joints(0.0));
  }
};

}  // namespace

TEST_CASE("a collision with a robot at rest is confirmed if that robot stays") {
  Neighbours both;
  const CollisionReport report = check_collisions(both.cell, 0, both.into_middle, {});
  CHECK_FALSE(report.is_refused);
  CHECK(report.certain.empty());
  REQUIRE(report.possible.size() == 1);
  CHECK(report.possible[0].met.other.robot == 1);
  const int motion = both.cell.start(0, both.into_middle);
  both.cell.advance_to(both.cell.report(motion).end_ns);
  const auto happened = confirmed_collisions(both.cell, motion, report.possible);
  REQUIRE(happened.size() == 1);
  CHECK(happened[0].other.robot == 1);
}

TEST_CASE("a collision with a robot that starts at the same instant is not confirmed") {
  Neighbours both;
  const CollisionReport report = check_collisions(both.cell, 0, both.into_middle, {});
  const int motion = both.cell.start(0, both.into_middle);
  both.cell.start(1, motion_to(*both.cell.robot(1).model, scara_joints(0.0), scara_joints(1.0)));
  both.cell.advance_to(both.cell.report(motion).end_ns);
  CHECK(confirmed_collisions(both.cell, motion, report.possible).empty());
}

TEST_CASE("a move that is stopped before a possible collision did not collide") {
  Neighbours both;
  const CollisionReport report = check_collisions(both.cell, 0, both.into_middle, {});
  const int motion = both.cell.start(0, both.into_middle);
  both.cell.advance_to(to_ns(0.1 * report.possible.at(0).met.t));
  both.cell.stop(0);
  both.cell.advance_to(both.cell.report(motion).end_ns);
  REQUIRE(both.cell.report(motion).state == MotionState::kStopped);
  CHECK(confirmed_collisions(both.cell, motion, report.possible).empty());
}

TEST_CASE("policies refuse collisions, ignore them, or leave out what is meant to touch") {
  Neighbours both;
  const auto check = [&](const MovePolicies& policies) {
    return check_collisions(both.cell, 0, both.into_middle, policies);
  };
  CHECK(check({.collisions = CollisionCheck::kError}).is_refused);
  CHECK(check({.avoid = true}).is_refused);
  const CollisionReport ignored = check({.collisions = CollisionCheck::kIgnore});
  CHECK_FALSE(ignored.is_refused);
  CHECK(ignored.possible.empty());

  Object post{.name = "post", .shape = Box{{0.05, 0.05, 1.0}}, .fixed = true};
  post.T_world_obj.translation() = Eigen::Vector3d(0.578, 0.395, 0.5);
  both.cell.insert(std::move(post));
  const CollisionReport reported = check({});
  REQUIRE(reported.certain.size() == 1);
  CHECK(reported.certain[0].other.object == "post");
  CHECK(check({.touching = true}).certain.empty());
  CHECK(check({.guarded = true}).certain.empty());  // a guard may stop the move before
}

TEST_CASE("torques beyond a limit are what inverse dynamics of the loaded arm says") {
  Random random(0x275);
  const auto robot = make_robot("ur5");
  int beyond = 0;
  for (int k = 0; k < 30; ++k) {
    Cell cell;
    const auto loaded =
        std::make_shared<const Robot>(robot->with_payload({.mass = 20.0 * random.uniform()}));
    cell.add_robot(loaded);
    VectorXd q1 = cell.robot(0).q;
    for (int i = 0; i < 6; ++i) q1[i] += 2.0 * random.uniform() - 1.0;
    const Trajectory motion = motion_to(*loaded, cell.robot(0).q, q1);
    const MotionForces forces = motion_forces(*loaded, motion);
    const bool is_beyond =
        forces.peaks[static_cast<std::size_t>(forces.nearest)].share() > 1.0 + 1e-9;
    beyond += is_beyond ? 1 : 0;
    const TorqueReport report = check_torques(cell, 0, motion, TorqueCheck::kError);
    CHECK(report.is_beyond() == is_beyond);
    CHECK(report.is_refused == is_beyond);
    CHECK_FALSE(check_torques(cell, 0, motion, TorqueCheck::kReport).is_refused);
    CHECK_FALSE(check_torques(cell, 0, motion, TorqueCheck::kIgnore).is_beyond());
    const TorqueReport limited = check_torques(cell, 0, motion, TorqueCheck::kLimit);
    if (is_beyond && std::isfinite(forces.slower)) {
      CHECK(limited.slower == forces.slower);
      CHECK_FALSE(limited.is_refused);
      CHECK(check_torques(cell, 0, motion, TorqueCheck::kLimit, true).is_refused);
    }
    const TorqueReport part =
        check_command_torques(cell, 0, motion, 0.0, motion.duration(), TorqueCheck::kLimit);
    CHECK(part.slower == 1.0);
    CHECK(part.is_refused == part.is_beyond());
  }
  CHECK(beyond > 5);
  CHECK(beyond < 30);
}

TEST_CASE("the excess of a motion is how far its curve swings out, not its ends") {
  const auto robot = make_robot("scara");
  const double upper = robot->upper()[0];
  // q(t) = upper - 0.1 + 2 t - 2 t^2 for 0 <= t <= 1 has its largest value at t = 1/2, 0.5 above
  // its ends.
  std::vector<JointPath> joints(4);
  joints[0] = {
      .segments = {{.start = 0.0, .duration = 1.0, .degree = 2, .c = {upper - 0.1, 2.0, -2.0}}},
      .q_end = upper - 0.1};
  const Trajectory motion(std::move(joints), 1.0);
  const auto outside = excesses(*robot, motion);
  REQUIRE(outside.size() == 1);
  CHECK(outside[0].joint == 0);
  CHECK(outside[0].excess() == doctest::Approx(0.4));
  CHECK(farthest(outside) == &outside[0]);
  CHECK(farthest({}) == nullptr);
  CHECK_FALSE(starts_and_stops(motion));  // it has a speed at both ends
  CHECK(starts_and_stops(motion_to(*robot, scara_joints(0.0), scara_joints(1.0))));
}

}  // namespace armlet
