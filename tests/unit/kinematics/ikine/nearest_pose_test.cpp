// The nearest pose of a failure is the nearest in place over all branches (language reference,
// section 13.6), against a dense search over the joint space with code of its own.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"
#include "sanitized.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int kGoals = kSanitized ? 2 : 15;

double distance(const Robot& robot, const VectorXd& q, const Vector3d& p) {
  return (forward(robot, q).translation() - p).norm();
}

// Downhill in steps of single joints and of pairs of them, ever smaller.
double descend(const Robot& robot, VectorXd q, const Vector3d& p, double step) {
  double best = distance(robot, q, p);
  while (step > 1e-7) {
    bool better = false;
    for (int i = 0; i < robot.n(); ++i) {
      for (int j = i; j < robot.n(); ++j) {
        for (int sign = 0; sign < 4; ++sign) {
          VectorXd next = q;
          next[i] += (sign & 1) != 0 ? step : -step;
          if (j != i) next[j] += (sign & 2) != 0 ? step : -step;
          next = clamp_to_limits(robot, next);
          const double there = distance(robot, next, p);
          if (there >= best) continue;
          best = there;
          q = next;
          better = true;
        }
      }
    }
    if (!better) step *= 0.5;
  }
  return best;
}

// The least distance: from the best points of a grid over the joints that move the tool point most.
double least_distance(const Robot& robot, const Vector3d& p) {
  constexpr int kSteps = 14;
  const int n = std::min(robot.n(), 3);
  struct Point {
    double distance;
    VectorXd q;
  };
  std::vector<Point> points;
  const int count = static_cast<int>(std::pow(kSteps + 1, n) + 0.5);
  for (int k = 0; k < count; ++k) {
    VectorXd q = clamp_to_limits(robot, VectorXd::Zero(robot.n()));
    for (int i = 0, rest = k; i < n; ++i, rest /= kSteps + 1) {
      const double share = static_cast<double>(rest % (kSteps + 1)) / kSteps;
      q[i] = robot.lower()[i] + share * (robot.upper()[i] - robot.lower()[i]);
    }
    points.push_back({distance(robot, q, p), q});
  }
  std::ranges::stable_sort(points, {}, &Point::distance);
  double best = INFINITY;
  for (std::size_t k = 0; k < std::min<std::size_t>(points.size(), 12); ++k)
    best = std::min(best, descend(robot, points[k].q, p, 0.2));
  return best;
}

Robot limited(const Robot& robot, Random& random) {
  RobotSpec spec = robot.spec();
  for (Joint& joint : spec.joints) {
    const double range = joint.upper - joint.lower;
    joint.lower += random.uniform(0.0, 0.3) * range;
    joint.upper -= random.uniform(0.0, 0.3) * range;
  }
  spec.home.resize(0);
  return Robot(spec);
}

}  // namespace

TEST_CASE("the nearest pose of a failure is the nearest in place of all branches") {
  Random random(55);
  for (const char* name :
       {"planar2", "planar3", "anthropomorphic", "scara", "scorbot", "puma560"}) {
    CAPTURE(name);
    int failed = 0, farther = 0;
    double worst = 0.0;
    for (int k = 0; k < kGoals; ++k) {
      const Robot robot = limited(*make_robot(name), random);
      const double size = 1.3 * robot.length();
      const Vector3d p(random.uniform(-size, size), random.uniform(-size, size),
                       random.uniform(-size, size));
      const IkResult ik = solve_ik(robot, make_translation(p),
                                   {.seed = random_joints(robot, random),
                                    .task = k % 2 == 0 ? IkTask::kPosition : IkTask::kPose});
      if (ik.ok() || ik.diagnosis.distance == 0.0) continue;
      ++failed;
      const IkDiagnosis& d = ik.diagnosis;
      CHECK(within_limits(robot, d.q_nearest, 0.0));
      CHECK(distance(robot, d.q_nearest, p) == doctest::Approx(d.distance).epsilon(1e-9));
      const double more = d.distance - least_distance(robot, p);
      farther += more > 1e-6 ? 1 : 0;
      worst = std::max(worst, more);
    }
    CHECK(failed > 0);
    CHECK(farther == 0);
    CHECK(worst < 1e-6);
  }
}

TEST_CASE("of the orientations at the nearest position the nearest is taken") {
  // Beyond the reach of the arm only its wrist can rotate: the goal's own orientation is left.
  const Robot robot = *make_robot("puma560");
  Random random(56);
  for (int k = 0; k < kGoals; ++k) {
    VectorXd q = VectorXd::Zero(6);
    q << random.uniform(-2, 2), random.uniform(-0.7, 0.3), 1.5, random.uniform(-1, 1),
        random.uniform(0.3, 1.2), random.uniform(-1, 1);
    const Isometry3d here = forward(robot, q);
    const Vector3d out = here.translation().normalized();
    const Isometry3d goal = make_pose(here.linear(), 3.0 * robot.length() * out);
    const IkResult place = solve_ik(robot, goal, {.task = IkTask::kPosition});
    const IkResult pose = solve_ik(robot, goal);
    REQUIRE_FALSE(pose.ok());
    CHECK(pose.diagnosis.distance == doctest::Approx(place.diagnosis.distance).epsilon(1e-6));
    CHECK(pose.diagnosis.angle <= angle_between(place.diagnosis.nearest, goal) + 1e-9);
    CHECK(pose.diagnosis.angle ==
          doctest::Approx(angle_between(pose.diagnosis.nearest, goal)).epsilon(1e-6));
  }
}

TEST_CASE("without limits the iterations find solutions beyond them") {
  // Six joints whose axes do not meet: no closed form.
  RobotSpec spec;
  const double alphas[] = {1.2, -0.8, 0.9, -1.1, 1.3, 0.0};
  for (int i = 0; i < 6; ++i) {
    Joint joint;
    joint.dh = {0.0, 0.1, 0.2, alphas[i]};
    joint.lower = 0.1;
    joint.upper = 0.7;
    spec.joints.push_back(joint);
  }
  const Robot narrow(spec);
  for (Joint& joint : spec.joints) {
    joint.lower = -kPi;
    joint.upper = kPi;
  }
  const Robot wide(spec);
  Random random(57);
  int found = 0, wanted = 0;
  for (int k = 0; k < 6; ++k) {
    const Isometry3d goal = forward(narrow, random_joints(narrow, random));
    const VectorXd seed = VectorXd::Constant(6, 0.4);
    found += static_cast<int>(
        solve_ik_all(narrow, goal, {.seed = seed, .respect_limits = false}).size());
    wanted += static_cast<int>(solve_ik_all(wide, goal, {.seed = seed}).size());
  }
  CHECK(wanted > 12);
  CHECK(found >= wanted);
}
