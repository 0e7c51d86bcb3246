#include "armlet/kinematics/reach_gap.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

ReachGap gap_at(const Robot& robot, const Isometry3d& goal) { return closed_form(robot).gap(goal); }

Eigen::Matrix3d random_rotation(Random& random) {
  return rotation_exp(
      Vector3d(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)));
}

}  // namespace

// Lengths of the Puma 560: Corke and Armstrong-Helouvry 1994.
TEST_CASE("the wrist centre of a Puma misses the stretched arm by what was put in") {
  const Robot puma = *make_robot("puma560");
  const double upper = 0.4318, fore = std::hypot(0.0203, 0.4318), offset = 0.15005;
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const double excess = random.uniform(0.001, 0.5);
    const double lift = random.uniform(-1.5, 1.5);
    const double R = upper + fore + excess;
    // In the plane of the arm, beside axis 1 by the shoulder's offset; its tool has no length.
    const Vector3d wrist = rot_z(random.uniform(-3, 3)) *
                           Vector3d(R * std::cos(lift), -offset, 0.67183 + R * std::sin(lift));
    const ReachGap gap = gap_at(puma, make_pose(random_rotation(random), wrist));
    CHECK(gap.kind == GapKind::kTooFar);
    CHECK(gap.point == GapPoint::kWristCentre);
    CHECK(gap.miss == doctest::Approx(excess).epsilon(1e-9));
    CHECK(gap.distance == doctest::Approx(R));
    CHECK(gap.links[0] == doctest::Approx(upper));
    CHECK(gap.links[1] == doctest::Approx(fore));
    CHECK(gap.from == 1);
  }
  const double R = upper + fore + 0.037;
  CHECK(describe(gap_at(puma, make_pose(rot_x(0.3), Vector3d(R, -offset, 0.67183)))) ==
        "the wrist centre is 37 mm beyond a2 + a3: 901.1 mm from axis 2, and links 2 and 3 are "
        "431.8 mm and 432.3 mm long");
}

TEST_CASE("the wrist centre of a Puma within its shoulder's offset is too close to axis 1") {
  const ReachGap gap = gap_at(*make_robot("puma560"), make_translation({0.09, 0.0, 0.9}));
  CHECK(gap.kind == GapKind::kTooClose);
  CHECK(gap.miss == doctest::Approx(0.06005));
  CHECK(describe(gap) ==
        "the wrist centre is 60 mm too close to axis 1: 90 mm from it, and the arm's offset "
        "keeps it 150 mm away");
}

// UR5: d4 = 109.15 mm, a2 = 425 mm, a3 = 392.25 mm (maker's DH table).
TEST_CASE("a UR5 is refused by its shoulder's offset or by the reach of its two links") {
  const Robot ur5 = *make_robot("ur5");
  const double d6 = 0.0823, d5 = 0.09465;
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const double beside = random.uniform(0.0, 0.1);
    const Eigen::Matrix3d R = random_rotation(random);
    const Vector3d wrist = rot_z(random.uniform(-3, 3)) * Vector3d(beside, 0, 0.5);
    const ReachGap gap = gap_at(ur5, make_pose(R, wrist + d6 * R.col(2)));
    CHECK(gap.kind == GapKind::kTooClose);
    CHECK(gap.miss == doctest::Approx(0.10915 - beside));
  }
  // The tool points up, so axis 5 lies level in the plane of the arm and takes axis 4 inwards by
  // d5.
  for (int k = 0; k < 100; ++k) {
    const double X = random.uniform(1.2, 2.0);
    const double Z = random.uniform(-1.0, 1.0);
    const Vector3d wrist = rot_z(random.uniform(-3, 3)) * Vector3d(X, -0.10915, 0.089159 + Z);
    const Eigen::Matrix3d tool = rot_z(random.uniform(-3, 3));
    const ReachGap gap = gap_at(ur5, make_pose(tool, wrist + d6 * tool.col(2)));
    CHECK(gap.kind == GapKind::kTooFar);
    CHECK(gap.point == GapPoint::kAxis);
    CHECK(gap.axis == 3);
    CHECK(gap.miss == doctest::Approx(std::hypot(X - d5, Z) - 0.425 - 0.39225));
  }
}

TEST_CASE("the elbow of an arm of seven joints stretches to the sum of its links") {
  // PA-10: 450 and 480 mm from the shoulder at 317 mm; the tool stands 70 mm beyond the wrist.
  const Robot pa10 = *make_robot("pa10");
  const ReachGap gap = gap_at(pa10, make_translation({1.0, 0.0, 0.317 + 0.07}));
  CHECK(gap.kind == GapKind::kTooFar);
  CHECK(gap.miss == doctest::Approx(0.07));
  CHECK(describe(gap) ==
        "the wrist centre is 70 mm beyond the stretched arm: 1000 mm from where axes 1 and 2 meet, "
        "and 930 mm is the farthest it gets");
}

TEST_CASE("a SCARA is refused by its two links, outside and inside") {
  const Robot scara = *make_robot("scara");  // 400 and 300 mm
  const ReachGap far = gap_at(scara, make_pose(rot_x(kPi), {0.6, 0.8, 0.3}));
  CHECK(far.kind == GapKind::kTooFar);
  CHECK(far.miss == doctest::Approx(0.3));
  const ReachGap near = gap_at(scara, make_pose(rot_x(kPi), {0.0, 0.06, 0.3}));
  CHECK(near.kind == GapKind::kTooNear);
  CHECK(near.miss == doctest::Approx(0.04));
  CHECK(describe(near) ==
        "the tool point is 40 mm inside |a1 - a2|: 60 mm from axis 1, and links 1 and 2 are 400 mm "
        "and 300 mm long");
}

TEST_CASE("a Stanford arm cannot get closer to its shoulder than its offsets") {
  // R. Paul 1981: d2 = 154 mm, and the wrist stands a3 = 20.3 mm back along axis 2.
  const Robot stanford = *make_robot("stanford");
  const double hole = 0.154 - 0.0203;
  const ReachGap gap = gap_at(stanford, make_pose(rot_x(0.4), {0.03, 0.04, 0.412}));
  CHECK(gap.kind == GapKind::kTooNear);
  CHECK(gap.miss == doctest::Approx(hole - 0.05));
  // Straight above the shoulder axis 2 would have to point upwards, and it is level.
  const ReachGap over = gap_at(stanford, make_pose(rot_x(0.4), {0.0, 0.0, 1.412}));
  CHECK(over.kind == GapKind::kTooHigh);
  CHECK(over.distance == doctest::Approx(1.0));
  CHECK(over.limit == doctest::Approx(std::sqrt(1.0 - hole * hole)));
}

TEST_CASE("three parallel axes do not leave their plane") {
  const Robot planar = *make_robot("planar3");
  Isometry3d goal = forward(planar, planar.home());
  goal.translation() += 0.025 * goal.linear().col(2);
  const ReachGap gap = gap_at(planar, goal);
  CHECK(gap.kind == GapKind::kOffPlane);
  CHECK(gap.miss == doctest::Approx(0.025));
}

TEST_CASE("there is a gap where and only where the formula has no solution") {
  Random random(3);
  for (const std::string_view name :
       {"rrr3", "puma560", "stanford", "pa10_6", "irb120", "ur3", "ur5", "ur10"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int without = 0;
    for (int k = 0; k < 20'000; ++k) {
      const double size = 0.8 * robot.reach();
      const Vector3d p(random.uniform(-size, size), random.uniform(-size, size),
                       random.uniform(-size, size));
      const Isometry3d goal = make_pose(random_rotation(random), p);
      ClosedSolutions solutions;
      closed_form(robot).solve(goal, robot.home(), solutions);
      const ReachGap gap = gap_at(robot, goal);
      without += gap.exists() ? 1 : 0;
      CHECK(gap.exists() == (solutions.count == 0));
      CHECK(gap.miss >= 0.0);
    }
    CHECK(without > 100);
    CHECK(without < 19'000);
  }
}

TEST_CASE("reachable poses have no gap, of arms read backwards and of five joints too") {
  Random random(4);
  for (const std::string_view name : {"scara", "scorbot", "planar3", "pa10", "iiwa14"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 5'000; ++k)
      CHECK_FALSE(gap_at(robot, forward(robot, random_joints(robot, random))).exists());
  }
}

TEST_CASE("the reason stands in the result, in the report and in the text") {
  const Robot puma = *make_robot("puma560");
  const Isometry3d goal =
      make_pose(rot_x(0.3), {0.4318 + std::hypot(0.0203, 0.4318) + 0.037, -0.15005, 0.67183});
  const IkReport report = report_ik(puma, goal);
  const IkResult& result = report.result;
  CHECK_FALSE(result.ok());
  CHECK(result.diagnosis.gap.kind == GapKind::kTooFar);
  CHECK(result.diagnosis.gap.miss == doctest::Approx(0.037));
  CHECK(to_text(puma, goal, report).find("the wrist centre is 37 mm beyond a2 + a3") !=
        std::string::npos);
}
