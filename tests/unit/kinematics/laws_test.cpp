// Laws of kinematics over many poses of every arm: the singular sets of the textbooks, and inverse
// kinematics to two tolerances with joints anywhere, one on a limit and all on limits.
#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

// The largest sigma_min of 200 configurations that `change` makes singular.
double worst_sigma(const Robot& robot, auto change) {
  Random random(1);
  double worst = 0.0;
  for (int k = 0; k < 200; ++k) {
    VectorXd q = random_joints(robot, random);
    change(q);
    worst = std::max(worst, singularity(robot, q).sigma_min);
  }
  return worst;
}

int failures(const Robot& robot, int count, double tolerance, auto choose_goal) {
  Random random(12);
  int failed = 0;
  for (int k = 0; k < count; ++k) {
    const Isometry3d goal = forward(robot, choose_goal(random));
    const IkResult ik = solve_ik(robot, goal,
                                 {.seed = random_joints(robot, random),
                                  .choice = IkChoice::kFirst,
                                  .position_tolerance = tolerance,
                                  .rotation_tolerance = tolerance});
    const Isometry3d reached = forward(robot, ik.q);
    const bool good = ik.ok() && within_limits(robot, ik.q) &&
                      (reached.translation() - goal.translation()).norm() < 1.001 * tolerance &&
                      angle_between(reached, goal) < 1.001 * tolerance + 1e-15;
    failed += good ? 0 : 1;
  }
  return failed;
}

constexpr double kRight = kPi / 2;

}  // namespace

// Sets in closed form: elbow, shoulder and wrist of each kind of arm. SRS arms: M. Kreutz-Delgado,
// M. Long, H. Seraji, Kinematic analysis of 7-DOF manipulators, Int. J. Robotics Research 11, 1992.
TEST_CASE("the singular sets of the textbooks are singular to rounding") {
  const auto at = [](int joint, double value) { return [=](VectorXd& q) { q[joint] = value; }; };
  CHECK(worst_sigma(*make_robot("planar2"), at(1, 0.0)) < 1e-15);
  CHECK(worst_sigma(*make_robot("scara"), at(1, 0.0)) < 1e-15);
  CHECK(worst_sigma(*make_robot("anthropomorphic"), at(2, 0.0)) < 1e-15);
  // The tool point over axis 1: a2 c2 + a3 c23 = 0.
  CHECK(worst_sigma(*make_robot("anthropomorphic"), [](VectorXd& q) {
          const double a2 = 0.45, a3 = 0.35;
          q[1] = std::atan2(a2 + a3 * std::cos(q[2]), a3 * std::sin(q[2]));
        }) < 1e-15);
  const Robot puma = *make_robot("puma560");
  CHECK(worst_sigma(puma, at(4, 0.0)) < 1e-15);
  // The wrist centre where the arm is stretched: at d4 and a3 from axis 3.
  CHECK(worst_sigma(puma, at(2, std::atan2(-0.4318, 0.0203) + 0.0)) < 1e-15);
  // The wrist centre on the cylinder of radius d3 about axis 1: a2 c2 + a3 c23 - d4 s23 = 0, up to
  // the sign that the convention gives joint 3.
  CHECK(worst_sigma(puma, [](VectorXd& q) {
          const double x = 0.4318 + 0.0203 * std::cos(q[2]) - 0.4318 * std::sin(q[2]);
          const double y = 0.0203 * std::sin(q[2]) + 0.4318 * std::cos(q[2]);
          q[1] = std::atan2(x, y);
        }) < 1e-15);
  const Robot pa10 = *make_robot("pa10");
  CHECK(worst_sigma(pa10, at(3, 0.0)) < 1e-15);
  const auto both = [](int i, double a, int j, double b) {
    return [=](VectorXd& q) {
      q[i] = a;
      q[j] = b;
    };
  };
  CHECK(worst_sigma(pa10, both(1, 0.0, 2, kRight)) < 1e-15);
  CHECK(worst_sigma(pa10, both(5, 0.0, 4, kRight)) < 1e-15);
  CHECK(worst_sigma(pa10, both(1, 0.0, 5, 0.0)) < 1e-15);
  // One of a pair alone is regular.
  CHECK(worst_sigma(pa10, at(1, 0.0)) > 0.01);
  CHECK(worst_sigma(pa10, at(5, 0.0)) > 0.01);
}

TEST_CASE("10,000 poses of every arm are found from any start, one limit or all limits included") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const auto on_limit = [&](Random& r, int i) {
      return r.below(2) == 0 ? robot.lower()[i] : robot.upper()[i];
    };
    for (const auto& [tolerance, on_limits] : {std::pair{1e-6, 1'000}, std::pair{1e-9, 10'000}}) {
      CHECK(failures(robot, 10'000, tolerance,
                     [&](Random& r) { return random_joints(robot, r); }) == 0);
      CHECK(failures(robot, on_limits, tolerance, [&](Random& r) {
              VectorXd q = random_joints(robot, r);
              const int i = static_cast<int>(r.below(static_cast<std::uint64_t>(robot.n())));
              q[i] = on_limit(r, i);
              return q;
            }) == 0);
      CHECK(failures(robot, on_limits, tolerance, [&](Random& r) {
              VectorXd q(robot.n());
              for (int i = 0; i < robot.n(); ++i) q[i] = on_limit(r, i);
              return q;
            }) == 0);
    }
  }
}
