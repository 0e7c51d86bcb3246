// kPositionFirst: a position to be reached with the orientation that there is, or with the one
// nearest to it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

double missed_by(const Robot& robot, const VectorXd& q, const Isometry3d& goal) {
  return (forward(robot, q).translation() - goal.translation()).norm();
}
double rotated_by(const Robot& robot, const VectorXd& q, const VectorXd& seed) {
  return angle_between(forward(robot, q), forward(robot, seed));
}

}  // namespace

TEST_CASE("an arm that only reaches positions has a closed form, rotating its tool least") {
  Random random(1);
  for (const std::string_view name : {"anthropomorphic", "planar2"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 300; ++k) {
      const Isometry3d goal = forward(robot, random_joints(robot, random));
      const VectorXd seed = random_joints(robot, random);
      const IkResult ik = solve_ik(robot, goal, {.seed = seed, .task = IkTask::kPositionFirst});
      REQUIRE(ik.ok());
      CHECK(ik.branch >= 0);
      CHECK(missed_by(robot, ik.q, goal) < 1e-8);
      // No solution that the iterations find rotates it less.
      for (const VectorXd& other : solve_ik_all(robot, goal,
                                                {.seed = seed,
                                                .task = IkTask::kPosition,
                                                .method = IkMethod::kNumeric,
                                                .starts = 20})) {
        CHECK(rotated_by(robot, ik.q, seed) < rotated_by(robot, other, seed) + 2e-6);
      }
    }
  }
}

TEST_CASE(
    "all solutions for a position: four of an elbow arm, as many as its pose has of a Scorbot") {
  const Robot elbow = *make_robot("anthropomorphic");
  const Isometry3d goal = make_translation({0.4, 0.2, 0.5});
  IkOptions options{.seed = elbow.home(), .task = IkTask::kPositionFirst, .respect_limits = false};
  const auto ways = solve_ik_all(elbow, goal, options);
  CHECK(ways.size() == 4);
  for (const VectorXd& q : ways) CHECK(missed_by(elbow, q, goal) < 1e-8);
  CHECK(report_ik(elbow, goal, options).branches.size() == 4);

  const Robot scorbot = *make_robot("scorbot");
  options.seed = scorbot.home();
  options.respect_limits = true;
  const Isometry3d place = make_translation({0.3, 0.2, 0.2});
  const IkResult one = solve_ik(scorbot, place, options);
  REQUIRE(one.ok());
  const auto all = solve_ik_all(scorbot, place, options);
  const auto is_one = [&](const VectorXd& q) { return (q - one.q).norm() < 1e-5; };
  CHECK(std::ranges::any_of(all, is_one));
  for (const VectorXd& q : all) {
    CHECK(missed_by(scorbot, q, place) < 1.001e-6);
    CHECK(angle_between(forward(scorbot, q), forward(scorbot, one.q)) < 1e-5);
  }
}

TEST_CASE("a position out of reach is known to be so without iterations, and the reason is given") {
  const Robot elbow = *make_robot("anthropomorphic");
  const IkResult ik =
      solve_ik(elbow, make_translation({0.9, 0.0, 0.4}), {.task = IkTask::kPositionFirst});
  CHECK(ik.status == IkStatus::kUnreachable);
  CHECK(ik.starts == 0);
  CHECK(ik.diagnosis.distance == doctest::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("the pose with the closest orientation is exactly at the position") {
  Random random(2);
  int count = 0;
  for (const std::string_view name : {"scorbot", "puma560", "ur5"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 60; ++k) {
      Isometry3d goal = forward(robot, random_joints(robot, random));
      goal.linear() = forward(robot, random_joints(robot, random)).linear();
      const IkResult ik = solve_ik(robot, goal);
      if (ik.status != IkStatus::kOrientationUnreachable) continue;
      ++count;
      CHECK((ik.diagnosis.nearest.translation() - goal.translation()).norm() < 1.001e-6);
      CHECK(angle_between(ik.diagnosis.nearest, goal) ==
            doctest::Approx(ik.diagnosis.angle).epsilon(1e-9));
    }
  }
  CHECK(count > 20);
}
