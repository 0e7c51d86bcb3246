// Why there is no solution: each case is constructed so that the true answer is known.
#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// The arm with every revolute joint free to make a full revolution.
Robot without_stops(const Robot& robot) {
  RobotSpec spec = robot.spec();
  for (Joint& joint : spec.joints) {
    if (!joint.is_revolute()) continue;
    joint.lower = -kPi;
    joint.upper = kPi;
  }
  return Robot(spec);
}

}  // namespace

TEST_CASE("whatever the goal and the seed are there is an answer, and a yes is true") {
  Random random(9);
  const double sizes[] = {0.0, 1e-300, 1e-9, 1e-3, 1.0, 10.0, 1e3, 1e6, 1e9, 1e160, 1e300};
  const auto any_size = [&] { return sizes[random.below(std::size(sizes))]; };
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 40; ++k) {
      Isometry3d goal = forward(robot, random_joints(robot, random));
      if (random.below(2) == 0) {
        for (double& x : goal.matrix().col(3).head<3>()) x = any_size() * random.uniform(-1, 1);
      }
      VectorXd seed = random_joints(robot, random);
      if (random.below(2) == 0) seed *= any_size();
      const IkTask tasks[] = {IkTask::kPose, IkTask::kPosition, IkTask::kPositionFirst};
      const IkTask task = tasks[random.below(3)];
      const IkResult ik =
          solve_ik(robot, goal, {.seed = seed, .task = task, .starts = 20, .diagnose = k % 8 == 0});
      REQUIRE(ik.q.allFinite());
      CHECK(explain(robot, goal, ik).find("nan") == std::string::npos);
      if (!ik.ok()) continue;
      const Isometry3d reached = forward(robot, ik.q);
      CHECK(within_limits(robot, ik.q));
      CHECK((reached.translation() - goal.translation()).norm() < 1.001e-6);
      if (task == IkTask::kPose) CHECK(angle_between(reached, goal) < 1.001e-6);
    }
  }
}

TEST_CASE(
    "a position beyond the reach is refused with the true distance and the nearest position") {
  // Lengths by hand: how far the tool point gets from a fixed point, whatever its orientation.
  struct Case {
    std::string_view arm;
    Vector3d centre;
    double reach;
  };
  Random random(1);
  for (const Case& c : {Case{"planar2", {0, 0, 0}, 2.0}, Case{"rrr3", {0, 0, 0.4}, 0.8}}) {
    CAPTURE(c.arm);
    const Robot robot = without_stops(*make_robot(c.arm));
    const Isometry3d home = forward(robot, robot.home());
    for (int k = 0; k < 50; ++k) {
      Vector3d u(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (c.arm == "planar2") u.y() = 0.0;
      u.normalize();
      const double excess = random.uniform(0.01, 1.0);
      const Vector3d p = c.centre + (c.reach + excess) * u;
      const IkResult ik = solve_ik(robot, make_pose(home.linear(), p), {.task = IkTask::kPosition});
      CHECK(ik.status == IkStatus::kUnreachable);
      CHECK(std::abs(ik.diagnosis.distance - excess) < 1e-6);
      CHECK((ik.diagnosis.nearest.translation() - (c.centre + c.reach * u)).norm() < 2e-3);
    }
  }
}

TEST_CASE("of no arm does any configuration come nearer than the nearest position that is named") {
  Random random(2);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 3; ++k) {
      Vector3d u(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      u.normalize();
      Isometry3d goal = forward(robot, random_joints(robot, random));
      goal.translation() = robot.T_world_base().translation() + 1.2 * robot.reach() * u;
      const IkResult ik = solve_ik(robot, goal);
      // What slides could get there if it slid far enough.
      bool slides = false;
      for (int i = 0; i < robot.n(); ++i) slides = slides || !robot.is_revolute(i);
      CHECK(
          (ik.status == IkStatus::kUnreachable || (slides && ik.status == IkStatus::kJointLimit)));
      const IkDiagnosis& d = ik.diagnosis;
      CHECK(d.distance >= 0.2 * robot.reach() - 1e-6);
      CHECK(within_limits(robot, d.q_nearest));
      const Vector3d nearest = forward(robot, d.q_nearest).translation();
      CHECK((nearest - d.nearest.translation()).norm() < 1e-9);
      CHECK((nearest - goal.translation()).norm() == doctest::Approx(d.distance));
      for (int other = 0; other < 2000; ++other) {
        const Vector3d p = forward(robot, random_joints(robot, random)).translation();
        CHECK((p - goal.translation()).norm() >= d.distance - 1e-6);
      }
    }
  }
}

TEST_CASE(
    "a pose beyond one joint's limit is refused with that joint and what it would have to be") {
  Random random(3);
  // Joints whose value no other branch of these arms can replace: the first and only prismatic
  // joint, and joint 1 of an arm that can face in one direction only.
  const Robot scara = *make_robot("scara");
  for (int k = 0; k < 50; ++k) {
    VectorXd q = random_joints(scara, random);
    const double excess = random.uniform(0.005, 0.3);
    q[2] = random.below(2) == 0 ? scara.upper()[2] + excess : scara.lower()[2] - excess;
    const IkResult ik = solve_ik(scara, forward(scara, q), {.seed = scara.home()});
    CHECK(ik.status == IkStatus::kJointLimit);
    bool named = false;
    for (const LimitViolation& v : ik.diagnosis.violations) {
      if (v.joint != 2) continue;
      named = true;
      CHECK(v.value == doctest::Approx(q[2]));
      CHECK(v.excess() == doctest::Approx(excess));
    }
    CHECK(named);
  }
}

TEST_CASE("what a joint would have to be really reaches the pose, and no branch needs less") {
  Random random(4);
  for (const std::string_view name : {"puma560", "irb120", "scorbot", "stanford"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int refused = 0;
    for (int k = 0; k < 200; ++k) {
      VectorXd q = random_joints(robot, random);
      const int joint = static_cast<int>(random.below(static_cast<std::uint64_t>(robot.n())));
      q[joint] = robot.upper()[joint] + random.uniform(0.05, 0.5);
      const Isometry3d goal = forward(robot, q);
      const IkResult ik = solve_ik(robot, goal, {.seed = robot.home()});
      if (ik.ok()) {  // another branch lies within
        CHECK(within_limits(robot, ik.q));
        continue;
      }
      ++refused;
      CHECK(ik.status == IkStatus::kJointLimit);
      double named = 0.0, least = INFINITY;
      for (const LimitViolation& v : ik.diagnosis.violations) named += v.excess();
      for (const VectorXd& other :
           solve_ik_all(robot, goal, {.seed = robot.home(), .respect_limits = false})) {
        double sum = 0.0;
        for (const LimitViolation& v :
             limit_violations(robot, wrap_near(robot, other, robot.home())))
          sum += v.excess();
        least = std::min(least, sum);
      }
      CHECK(named == doctest::Approx(least));
    }
    CHECK(refused > 0);
  }
}

TEST_CASE("the tool of a Scorbot cannot leave the plane of the arm: the angle is named") {
  const Robot robot = *make_robot("scorbot");
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    VectorXd q = 0.5 * (robot.home() + random_joints(robot, random));
    const Isometry3d pose = forward(robot, q);
    const Vector3d radial = (pose.translation() - robot.T_world_base().translation());
    if (radial.head<2>().norm() < 0.15) continue;
    // Normal of the plane of the arm, and the tool's axis tilted towards it.
    const Vector3d normal = link_frame(robot, q, 1).linear().col(2);
    const Vector3d z = pose.linear().col(2);
    const double tilt = random.uniform(0.05, 0.4);
    const Vector3d axis = z.cross(normal).normalized();
    const Isometry3d goal =
        make_pose(rotation_exp(tilt * axis) * pose.linear(), pose.translation());
    const IkResult ik = solve_ik(robot, goal, {.seed = q});
    CHECK(ik.status == IkStatus::kOrientationUnreachable);
    CHECK(ik.diagnosis.distance == 0.0);
    CHECK(ik.diagnosis.angle == doctest::Approx(tilt).epsilon(2e-3));
    CHECK(explain(robot, goal, ik).find("not with this orientation") != std::string::npos);
  }
}
