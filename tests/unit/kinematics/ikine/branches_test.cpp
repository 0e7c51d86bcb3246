// Of arms solved by iteration every single solution is found, next to singular positions too.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "general_arm.hpp"
#include "kinematics/ik/ik_search.hpp"
#include "random_arm.hpp"
#include "sanitized.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

constexpr int kScale = kSanitized ? 20 : 1;

bool contains(const Robot& robot, const std::vector<VectorXd>& list, const VectorXd& q) {
  for (const VectorXd& other : list) {
    double most = 0.0;
    for (int i = 0; i < robot.n(); ++i) {
      const double apart = q[i] - other[i];
      most = std::max(most, std::abs(robot.is_revolute(i) ? wrap_angle(apart) : apart));
    }
    if (most < 1e-3) return true;
  }
  return false;
}

// Every solution that a thousand starts lead to, exactly.
std::vector<VectorXd> by_many_starts(const Robot& robot, const Eigen::Isometry3d& goal,
                                     IkOptions options) {
  options.position_tolerance = options.rotation_tolerance = 1e-12;
  options.iterations = 60;
  options.starts = 1000;
  return search_ik(robot, make_goal(robot, goal, options), options, 64, options.starts).solutions;
}

}  // namespace

TEST_CASE("of general arms with six joints every solution is found") {
  Random random(12);
  int goals = 0;
  for (int k = 0; k < (60 + kScale - 1) / kScale; ++k) {
    CAPTURE(k);
    const Robot robot = general_arm(random, k % 4 == 3);
    REQUIRE_FALSE(closed_form(robot).exists());
    VectorXd q = random_joints(robot, random);
    const VectorXd seed = random_joints(robot, random);
    if (k % 2 == 0) {
      const auto singular = singular_value(robot, q, 4);
      if (!singular) continue;
      q[4] = *singular + (k % 4 == 0 ? 1e-3 : 1e-4);
    }
    ++goals;
    const Eigen::Isometry3d goal = forward(robot, q);
    const IkOptions options{.seed = seed, .respect_limits = false};
    const std::vector<VectorXd> all = solve_ik_all(robot, goal, options, 32);
    CHECK(contains(robot, all, q));
    for (const VectorXd& other : by_many_starts(robot, goal, options))
      CHECK(contains(robot, all, other));
    // Solutions of such a goal come in pairs that meet at singular ones.
    if (k % 4 != 3) CHECK(all.size() % 2 == 0);
    for (const VectorXd& solution : all) {
      CHECK((forward(robot, solution).translation() - goal.translation()).norm() < 1e-6);
      CHECK(angle_between(forward(robot, solution), goal) < 1e-6);
    }
    // Of those inside the limits the nearest one is taken.
    double least = (clamp_to_limits(robot, q) - seed).cwiseAbs().maxCoeff();
    for (const VectorXd& other : by_many_starts(robot, goal, {.seed = seed}))
      least = std::min(least, (other - seed).cwiseAbs().maxCoeff());
    const IkResult nearest = solve_ik(robot, goal, {.seed = seed});
    REQUIRE(nearest.ok());
    CHECK((nearest.q - seed).cwiseAbs().maxCoeff() <= least + 1e-6);
  }
  CHECK(goals >= 40 / kScale);
}

TEST_CASE("next to singular positions the iterations find what the formula finds") {
  Random random(13);
  for (const char* name : {"ur5", "puma560"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int farther = 0, fewer = 0;
    for (int k = 0; k < 200 / kScale; ++k) {
      VectorXd q = random_joints(robot, random);
      q[k % 2 == 0 ? 4 : 2] = std::pow(10.0, -random.uniform(2.0, 5.0));
      VectorXd seed = q;
      for (double& value : seed) value += random.uniform(-0.3, 0.3);
      seed = clamp_to_limits(robot, k % 3 == 0 ? random_joints(robot, random) : seed);
      const Eigen::Isometry3d goal = forward(robot, q);
      const IkResult exact = solve_ik(robot, goal, {.seed = seed});
      const IkResult found = solve_ik(robot, goal, {.seed = seed, .method = IkMethod::kNumeric});
      REQUIRE(exact.ok());
      REQUIRE(found.ok());
      const Eigen::Isometry3d T = forward(robot, exact.q);
      const bool uses_tolerance =
          (T.translation() - goal.translation()).norm() > 1e-9 || angle_between(T, goal) > 1e-8;
      if (uses_tolerance) continue;
      const double change = (found.q - seed).cwiseAbs().maxCoeff();
      farther += change > (exact.q - seed).cwiseAbs().maxCoeff() + 1e-6 ? 1 : 0;
      const IkOptions numeric{.seed = seed, .method = IkMethod::kNumeric, .respect_limits = false};
      const auto all = solve_ik_all(robot, goal, numeric, 64);
      for (const VectorXd& other :
           solve_ik_all(robot, goal, {.seed = seed, .respect_limits = false}))
        fewer += contains(robot, all, other) ? 0 : 1;
    }
    CHECK(farther == 0);
    CHECK(fewer == 0);
  }
}

// Next to a singular wrist hardly anything is left of the goal while the last joint rotates,
// and with the elbow next to stretched as well solutions lie close to each other along the curve.
TEST_CASE("with a wrist all but singular every solution is listed, and hardly anything else") {
  Random random(14);
  const Robot robot = *make_robot("ur5");
  int all = 0, listed = 0, missed = 0;
  for (int k = 0; k < 150 / kScale; ++k) {
    VectorXd q = random_joints(robot, random);
    q[4] = std::pow(10.0, -random.uniform(4.0, 5.0));
    if (k % 2 == 0) q[2] = std::pow(10.0, -random.uniform(2.0, 3.0));
    const Eigen::Isometry3d goal = forward(robot, q);
    const IkOptions exact{.seed = random_joints(robot, random), .respect_limits = false};
    IkOptions numeric = exact;
    numeric.method = IkMethod::kNumeric;
    const auto found = solve_ik_all(robot, goal, numeric, 64);
    listed += static_cast<int>(found.size());
    for (const VectorXd& other : solve_ik_all(robot, goal, exact)) {
      ++all;
      missed += contains(robot, found, other) ? 0 : 1;
    }
  }
  CHECK(missed == 0);
  CHECK(listed >= all);
  CHECK(listed <= all + all / 50);
}

// Two solutions meet where the elbow is stretched. Nothing else is inside the limits, and the
// iterations stop 1e-5 rad before it.
TEST_CASE("two solutions that meet at the limits of joints are one inside them") {
  const Robot robot = *make_robot("ur5");
  const double most = robot.upper()[0];
  const auto change = [&](std::vector<double> at, int joint, double by) {
    const VectorXd q = VectorXd::Map(at.data(), robot.n());
    VectorXd seed = q;
    seed[joint] += by;
    const IkOptions options{.seed = seed, .method = IkMethod::kNumeric};
    const IkResult ik = solve_ik(robot, forward(robot, q), options);
    REQUIRE(ik.ok());
    CHECK(within_limits(robot, ik.q, 0.0));
    return (ik.q - seed).cwiseAbs().maxCoeff();
  };
  CHECK(change({-3.973388722968147, -most, -most, 5.8576468077354704, 0.93608435013204438,
                4.8396922591411347},
               0, -kPi / 18) < kPi / 18 + 1e-6);
  CHECK(change({-4.1992084614189746, most, most, 0.22770251348076265, -5.0698601227415852,
                -4.6861235902057929},
               5, -kPi / 18) < kPi / 18 + 1e-6);
  CHECK(change({-3.755659001450518, most, most, -0.45525771574450768, -4.3952496496537652,
                0.36761661308151705},
               5, kPi / 18) < kPi / 18 + 1e-6);
  // The wrist all but singular as well: rounding alone decides whether the two meet.
  CHECK(change({1.9893321843412544, 4.3895419170089802, -most, 2.3795284698788315,
                -7.7384004309902319e-05, -2.3617946658082496},
               1, -kPi / 18) < kPi / 18 + 1e-6);
  CHECK(change({5.7373176445924354, 4.3776312737502199, most, -4.6701030121777549,
                1.7944230900357323e-06, 0.92137351853723715},
               3, kPi / 18) < kPi / 18 + 1e-6);
}

TEST_CASE("next to where two solutions meet the nearer one is taken") {
  Random random(15);
  for (const char* name : {"ur5", "puma560"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    double worst = 0.0;
    for (int k = 0; k < 200 / kScale; ++k) {
      VectorXd q = random_joints(robot, random);
      const auto stretched = singular_value(robot, q, 2);
      if (!stretched) continue;
      q[2] = *stretched + (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, -random.uniform(4.0, 8.0));
      if (!within_limits(robot, q, 0.0)) continue;
      const VectorXd seed = clamp_to_limits(robot, q + VectorXd::Constant(6, 1e-3 * (k % 7 - 3)));
      const IkOptions options{.seed = seed, .method = IkMethod::kNumeric};
      const IkResult ik = solve_ik(robot, forward(robot, q), options);
      REQUIRE(ik.ok());
      const double change = (ik.q - seed).cwiseAbs().maxCoeff();
      worst = std::max(worst, change - (q - seed).cwiseAbs().maxCoeff());
    }
    CHECK(worst < 1e-6);
  }
}
