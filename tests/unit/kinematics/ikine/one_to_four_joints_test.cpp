// Arms of one to four revolute joints of any structure (with the subproblems of Paden and Kahan:
// every one of them that has no joint to spare has a closed form).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "arm_of_rows.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik_report.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "backwards.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

Robot revolute_arm(Random& random, int n) {
  RobotSpec spec;
  spec.convention = random.below(2) == 0 ? DhConvention::kStandard : DhConvention::kModified;
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.dh = {random_length(random), random_length(random), random_length(random),
                random_twist(random)};
    joint.lower = -3.1;
    joint.upper = 3.1;
    spec.joints.push_back(joint);
  }
  spec.T_world_base = random_placement(random);
  spec.T_flange_tool = random_placement(random);
  return Robot(spec);
}

// Five joints of which the last two axes meet, or six of which the last three do, the others
// anywhere.
Robot wrist_arm(Random& random, int n) {
  RobotSpec spec;
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.dh = {random.uniform(-1, 1), random.uniform(-0.4, 0.4), random.uniform(0.1, 0.5),
                random.uniform(0.4, 1.4) * (random.below(2) == 0 ? 1.0 : -1.0)};
    joint.lower = -3.1;
    joint.upper = 3.1;
    spec.joints.push_back(joint);
  }
  spec.joints[3].dh.a = 0.0;
  if (n == 6) spec.joints[4].dh.a = spec.joints[4].dh.d = 0.0;
  // The first two axes may be parallel, or the next two (a family of its own with six joints).
  if (random.below(3) == 0) spec.joints[0].dh.alpha = 0.0;
  return Robot(spec);
}

double distance(const VectorXd& a, const VectorXd& b) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  return largest;
}

}  // namespace

TEST_CASE("every pose of an arm of one to four revolute joints gives back its joints") {
  Random random(1);
  for (int n = 1; n <= 4; ++n) {
    CAPTURE(n);
    int missing = 0, count = 0;
    for (int k = 0; k < 400; ++k) {
      const Robot robot = revolute_arm(random, n);
      const ClosedForm& closed = closed_form(robot);
      if (!closed.exists() || closed.kind() == ClosedFormKind::kPlane) continue;
      for (int j = 0; j < 100; ++j) {
        const VectorXd q = random_joints(robot, random);
        const Isometry3d goal = forward(robot, q);
        ClosedSolutions solutions;
        closed.solve(goal, q, solutions);
        const auto is_q = [&](const ClosedSolution& s) { return distance(q, s.joints()) < 1e-6; };
        missing += std::ranges::none_of(solutions, is_q) ? 1 : 0;
        ++count;
        for (const ClosedSolution& s : solutions) {
          const Isometry3d back = forward(robot, s.joints());
          CHECK((back.translation() - goal.translation()).norm() <= 1e-9);
          if (!closed.position_only())
            CHECK(rotation_log(back.linear() * goal.linear().transpose()).norm() <= 1e-9);
        }
      }
    }
    CHECK(missing == 0);
    CHECK(count >= 20'000);
  }
}

TEST_CASE("planar2 and arms of its kind: both elbows, and the reason when there is none") {
  const Robot planar = *make_robot("planar2");  // two links of 1 m in the x-z plane
  const IkReport report =
      report_ik(planar, make_translation({0.8, 0.0, 0.9}), {.task = IkTask::kPosition});
  REQUIRE(report.result.ok());
  CHECK(report.kind == ClosedFormKind::kFewPosition);
  CHECK(report.result.iterations == 0);
  CHECK(report.branches.size() == 2);
  const IkResult far =
      solve_ik(planar, make_translation({3.0, 0.0, 0.0}), {.task = IkTask::kPosition});
  CHECK(far.status == IkStatus::kUnreachable);
  CHECK(far.diagnosis.gap.kind == GapKind::kTooFar);
  CHECK(far.diagnosis.gap.miss == doctest::Approx(1.0));
}

TEST_CASE("a position is reached by four solutions at most, and every one is listed") {
  // Against a dense search: values of joint 3 where the remaining equation changes its sign.
  Random random(2);
  int most = 0;
  for (int k = 0; k < 300; ++k) {
    RobotSpec spec;
    for (int i = 0; i < 3; ++i) {
      Joint joint;
      joint.dh = {0, random.uniform(-0.3, 0.3), random.uniform(0.1, 0.5), random.uniform(0.3, 1.4)};
      spec.joints.push_back(joint);
    }
    const Robot robot(spec);
    const Eigen::Vector3d p = forward(robot, random_values(random, 3)).translation();
    ClosedSolutions solutions;
    closed_form(robot).solve(make_translation(p), VectorXd::Zero(3), solutions);
    CHECK(solutions.count >= 1);
    CHECK(solutions.count <= 4);
    CHECK(solutions.count % 2 == 0);  // they come in pairs away from the boundary of the reach
    most = std::max(most, solutions.count);
    // The numerical search finds no other.
    for (const VectorXd& other :
         solve_ik_all(robot, make_translation(p),
                      {.task = IkTask::kPosition, .method = IkMethod::kNumeric, .starts = 30})) {
      const auto is_it = [&](const ClosedSolution& s) {
        return distance(other, s.joints()) < 1e-4;
      };
      CHECK(std::ranges::any_of(solutions, is_it));
    }
  }
  CHECK(most == 4);
}

TEST_CASE("where joints are left over there is no closed form, and none is claimed") {
  // Two joints about one line, four parallel axes, four axes through a point.
  for (const Robot& robot :
       {arm_of({{0, 0.3, 0, 0}, {0, 0.1, 0.4, 1.0}, {0, 0, 0.3, 0}}),
        arm_of({{0, 0, 0.4, 1.0}, {0, 0.1, 0, 0}, {0, 0, 0.3, 0}}),
        arm_of({{0, 0, 0.4, 0}, {0, 0, 0.3, 0}, {0, 0, 0.3, 0}, {0, 0, 0.1, 0}}),
        arm_of({{0, 0, 0, 1.0}, {0, 0, 0, 1.2}, {0, 0, 0, -1.1}, {0, 0.1, 0.2, 0}})}) {
    CHECK_FALSE(closed_form(robot).exists());
    const VectorXd q = VectorXd::Constant(robot.n(), 0.4);
    CHECK(solve_ik(robot, forward(robot, q), {.seed = VectorXd::Zero(robot.n())}).ok());
  }
}

TEST_CASE("a wrist of three joints rotates its tool by a closed form") {
  RobotSpec spec;
  for (const double alpha : {1.1, -0.9, 0.0}) {
    Joint joint;
    joint.dh = {0, 0, 0, alpha};
    spec.joints.push_back(joint);
  }
  spec.T_flange_tool.translation() = Eigen::Vector3d(0.1, 0.0, 0.2);
  const Robot wrist(spec);
  CHECK(closed_form(wrist).kind() == ClosedFormKind::kFewPose);
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const VectorXd q = random_values(random, 3);
    ClosedSolutions solutions;
    CHECK(closed_form(wrist).solve(forward(wrist, q), q, solutions) == 2);
  }
}

TEST_CASE("a folded arm whose tool lies on its first axis keeps that joint where it is") {
  const Robot planar = *make_robot("planar2");
  const VectorXd q = Eigen::Vector2d(0.7, kPi);
  ClosedSolutions solutions;
  REQUIRE(closed_form(planar).solve(forward(planar, q), q, solutions) >= 1);
  CHECK(solutions.free);
  CHECK(distance(q, solutions.at[0].joints()) < 1e-7);
  const IkResult ik = solve_ik(planar, forward(planar, q), {.seed = VectorXd::Zero(2)});
  CHECK(ik.ok());  // the pose: its orientation determines joint 1
}

TEST_CASE("five joints with a wrist of two and six with one of three need no family") {
  Random random(4);
  for (const int n : {5, 6}) {
    CAPTURE(n);
    int missing = 0, count = 0, most = 0;
    for (int k = 0; k < 100; ++k) {
      const Robot forth = wrist_arm(random, n);
      for (const bool back : {false, true}) {
        const Robot robot = back ? backwards(forth) : forth;
        const ClosedForm& closed = closed_form(robot);
        REQUIRE(closed.exists());
        CHECK(closed.reversed() == back);
        for (int j = 0; j < 100; ++j) {
          const VectorXd q = random_joints(robot, random);
          const Isometry3d goal = forward(robot, q);
          ClosedSolutions solutions;
          most = std::max(most, closed.solve(goal, q, solutions));
          const auto is_q = [&](const ClosedSolution& s) { return distance(q, s.joints()) < 1e-6; };
          missing += std::ranges::none_of(solutions, is_q) ? 1 : 0;
          ++count;
          for (const ClosedSolution& s : solutions) {
            const Isometry3d reached = forward(robot, s.joints());
            CHECK((reached.translation() - goal.translation()).norm() <= 1e-9);
            CHECK(rotation_log(reached.linear() * goal.linear().transpose()).norm() <= 1e-9);
          }
        }
      }
    }
    CHECK(missing == 0);
    CHECK(count == 20'000);
    CHECK(most == (n == 6 ? 8 : 1));
  }
}
