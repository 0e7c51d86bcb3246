#include "armlet/kinematics/ik_report.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::VectorXd;

TEST_CASE("a report lists every branch with the joints that rule it out") {
  Random random(1);
  for (const std::string_view name : {"scara", "scorbot", "puma560", "ur5", "pa10"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 20; ++k) {
      VectorXd q(robot.n());
      for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
      const Eigen::Isometry3d goal = forward(robot, q);
      const IkReport report = report_ik(robot, goal, {.seed = q});
      REQUIRE(report.result.ok());
      CHECK(report.kind != ClosedFormKind::kNone);
      REQUIRE_FALSE(report.branches.empty());
      int taken = 0;
      for (const BranchReport& branch : report.branches) {
        CHECK((forward(robot, branch.q).matrix() - goal.matrix()).norm() < 1e-8);
        CHECK(branch.outside.empty() == within_limits(robot, branch.q));
        taken += (branch.q - report.result.q).norm() < 1e-6;
      }
      CHECK(taken == 1);
      const std::string text = to_text(robot, goal, report);
      CHECK(text.find("closed form for ") != std::string::npos);
      CHECK(text.find("\n> ") != std::string::npos);
    }
  }
}

TEST_CASE("a report of a SCARA says which joint rules out each elbow and by how much") {
  const Robot scara = *make_robot("scara");
  const Eigen::Isometry3d goal = make_pose(rot_x(kPi), {0.4, 0.2, 0.10});  // 250 mm below the arm
  const IkReport report = report_ik(scara, goal);
  CHECK_FALSE(report.result.ok());
  REQUIRE(report.branches.size() == 2);
  for (const BranchReport& branch : report.branches) {
    REQUIRE_FALSE(branch.outside.empty());
    CHECK(branch.outside[0].joint == 2);
    CHECK(branch.outside[0].excess() == doctest::Approx(0.05));
  }
  const std::string text = to_text(scara, goal, report);
  CHECK(text.find("joint 3 would slide to 250 mm, 50 mm beyond its limit of 200 mm") !=
        std::string::npos);
  CHECK(text.find("elbow left") != std::string::npos);
  CHECK(text.find("elbow right") != std::string::npos);
}

TEST_CASE("a question that cannot be asked has no branches") {
  const Robot scara = *make_robot("scara");
  const IkReport report =
      report_ik(scara, forward(scara, scara.home()), {.seed = VectorXd::Zero(3)});
  CHECK(report.result.status == IkStatus::kBadSize);
  CHECK(report.branches.empty());
}
