#include "armlet/kinematics/posture.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

TEST_CASE("a posture near given joint values falls off with the square of the distance") {
  const Robot arm = *make_robot("scara");
  const VectorXd given = arm.home();
  const PostureGoal goal(Posture::kNearGiven, given);
  CHECK(posture_value(arm, given, goal) == 0.0);
  VectorXd q = given;
  q[1] += 0.5 * (arm.upper()[1] - arm.lower()[1]);  // half of its range: -(1/2)^2 / (2 n)
  CHECK(posture_value(arm, q, goal) == doctest::Approx(-0.25 / 8.0));
  CHECK(posture_gradient(arm, q, goal)[1] < 0.0);
  CHECK_THROWS_AS(posture_value(arm, q, PostureGoal(Posture::kNearGiven, VectorXd::Zero(3))),
                  ArgumentError);
}

TEST_CASE("the gradient of a posture near given joint values is its derivative") {
  Random random(1);
  const Robot arm = *make_robot("pa10");
  const PostureGoal goal(Posture::kNearGiven, random_joints(arm, random));
  const VectorXd q = random_joints(arm, random);
  const VectorXd gradient = posture_gradient(arm, q, goal);
  for (int i = 0; i < arm.n(); ++i) {
    VectorXd above = q, below = q;
    above[i] += 1e-4;
    below[i] -= 1e-4;
    CHECK(
        gradient[i] ==
        doctest::Approx((posture_value(arm, above, goal) - posture_value(arm, below, goal)) / 2e-4)
            .epsilon(1e-6));
  }
}

TEST_CASE("of an arm without spare joints the branch with the best posture is taken") {
  Random random(2);
  for (const std::string_view name : {"puma560", "ur5", "irb120", "scara"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int changed = 0;
    for (int k = 0; k < 100; ++k) {
      const VectorXd seed = random_joints(robot, random);
      const Isometry3d goal = forward(robot, random_joints(robot, random));
      const PostureGoal postures[] = {Posture::kMidRange,
                                      Posture::kManipulability,
                                      {Posture::kNearGiven, random_joints(robot, random)}};
      for (const PostureGoal& posture : postures) {
        const IkResult ik = solve_ik(robot, goal, {.seed = seed, .posture = posture});
        REQUIRE(ik.ok());
        CHECK((forward(robot, ik.q).matrix() - goal.matrix()).norm() < 1e-6);
        CHECK(within_limits(robot, ik.q));
        CHECK(ik.posture == doctest::Approx(posture_value(robot, ik.q, posture)));
        for (const VectorXd& other : solve_ik_all(robot, goal, {.seed = seed}))
          CHECK(posture_value(robot, other, posture) <= ik.posture + 1e-9);
        CHECK(ik.branch >= 0);
        changed += (ik.q - solve_ik(robot, goal, {.seed = seed}).q).norm() > 1e-3;
      }
    }
    CHECK(changed > 20);
  }
}

TEST_CASE("an arm with a joint to spare gets into a better posture than any branch") {
  Random random(3);
  for (const std::string_view name : {"pa10", "panda"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int better = 0;
    for (int k = 0; k < 10; ++k) {
      const VectorXd q = random_joints(robot, random);
      const Isometry3d goal = forward(robot, q);
      for (const Posture posture : {Posture::kMidRange, Posture::kManipulability}) {
        const IkResult ik = solve_ik(robot, goal, {.seed = q, .posture = posture});
        REQUIRE(ik.ok());
        CHECK(ik.position_error <= 1e-6);
        CHECK(ik.rotation_error <= 1e-6);
        CHECK(within_limits(robot, ik.q, 0.0));
        CHECK(ik.posture >= posture_value(robot, q, posture) - 1e-12);
        better += ik.posture > posture_value(robot, q, posture) + 1e-6;
      }
    }
    CHECK(better >= 18);
  }
}

TEST_CASE("rows that a mask leaves out are freedom for the posture") {
  const Robot puma = *make_robot("puma560");
  Random random(4);
  const VectorXd q = random_joints(puma, random);
  const IkResult ik = solve_ik(puma, forward(puma, q),
                               {.seed = q,
                                .task = IkTask::kMasked,
                                .mask = {true, true, true, false, false, false},
                                .posture = Posture::kManipulability});
  REQUIRE(ik.ok());
  CHECK((forward(puma, ik.q).translation() - forward(puma, q).translation()).norm() < 1e-6);
  CHECK(ik.posture > manipulability(puma, q));
}

TEST_CASE("a given posture of another size or with values that are not finite is refused") {
  const Robot arm = *make_robot("scara");
  const Isometry3d here = forward(arm, arm.home());
  CHECK(solve_ik(arm, here, {.posture = PostureGoal(Posture::kNearGiven, VectorXd::Zero(3))})
            .status == IkStatus::kBadSize);
  CHECK(
      solve_ik(arm, here, {.posture = PostureGoal(Posture::kNearGiven, VectorXd::Constant(4, NAN))})
          .status == IkStatus::kNotFinite);
}

TEST_CASE("a report says for which posture a solution was chosen") {
  const Robot puma = *make_robot("puma560");
  const Isometry3d here = forward(puma, puma.home());
  const IkReport report = report_ik(puma, here, {.posture = Posture::kMidRange});
  CHECK(to_text(puma, here, report).find("chosen because there the middle") != std::string::npos);
}
