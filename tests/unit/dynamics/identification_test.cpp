#include "armlet/dynamics/identification.hpp"

#include <doctest/doctest.h>

#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/model/catalog.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Links with dry friction, that differs by direction, and viscous friction.
Robot with_friction(Random& random, Robot robot) {
  for (int i = 0; i < robot.n(); ++i) {
    Link link = robot.link(i);
    link.friction = {.viscous = random.uniform(0.0, 2e-3),
                     .coulomb_plus = random.uniform(0.0, 0.4),
                     .coulomb_minus = random.uniform(-0.4, 0.0)};
    robot = robot.with_link(i, link);
  }
  return robot;
}

// How many of the columns describe masses and moments.
Index mass_columns(const BaseParameters& base) {
  return std::count_if(base.columns.begin(), base.columns.end(),
                       [](int column) { return column % kLinkParameters < 10; });
}

// An arm without any parallel or crossing axes.
Robot general_arm(Random& random, int n, bool may_slide) {
  RobotSpec spec;
  spec.convention = random.below(2) == 0 ? DhConvention::kStandard : DhConvention::kModified;
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.kind = may_slide && random.below(3) == 0 ? JointKind::kPrismatic : JointKind::kRevolute;
    joint.dh = {random.uniform(0.3, 1.0), random.uniform(0.1, 0.5), random.uniform(0.1, 0.5),
                random.uniform(0.4, 1.2)};
    spec.joints.push_back(joint);
    spec.links.push_back(random_link(random));
  }
  if (random.below(2) == 0) spec.gravity = {1.0, 5.0, -8.0};
  return Robot(spec);
}

}  // namespace

TEST_CASE("the regressor times the parameters gives the forces of inverse dynamics") {
  Random random(12);
  double worst = 0.0;
  for (int k = 0; k < 1'200; ++k) {
    const int n = 1 + k % kMaxJoints;
    const Robot robot = with_friction(random, random_heavy_arm(random, n));
    const Link body = random_link(random);
    const Robot loaded =
        robot.with_payload({.mass = body.mass, .com = body.com, .inertia = body.inertia});
    VectorXd qd = random_rates(random, n);
    if (k % 3 == 0) qd[static_cast<Index>(random.below(static_cast<std::uint64_t>(n)))] = 0.0;
    const VectorXd q = random_values(random, n), qdd = random_rates(random, n);
    for (const Robot& each : {robot, loaded}) {
      const VectorXd tau = inverse_dynamics(each, q, qd, qdd);
      const VectorXd linear = dynamics_regressor(each, q, qd, qdd) * dynamic_parameters(each);
      worst = std::max(worst, (linear - tau).norm() / (1.0 + tau.norm()));
    }
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("the regressor does not depend on masses") {
  Random random(13);
  const Robot robot = random_heavy_arm(random, 5);
  const Robot other = robot.with_link(2, random_link(random)).with_payload({.mass = 3.0});
  const VectorXd q = random_values(random, 5), qd = random_rates(random, 5),
                 qdd = random_rates(random, 5);
  CHECK(dynamics_regressor(robot, q, qd, qdd) == dynamics_regressor(other, q, qd, qdd));
}

TEST_CASE("base parameters give all forces, and none of them can be left out") {
  Random random(14);
  for (int k = 0; k < 60; ++k) {
    const int n = 1 + k % 7;
    const Robot robot = with_friction(random, random_heavy_arm(random, n));
    const BaseParameters base = base_parameters(robot);
    const VectorXd p = dynamic_parameters(robot), p_base = base.grouping * p;
    MatrixXd stacked(40 * n, static_cast<Index>(base.columns.size()));
    for (Index sample = 0; sample < 40; ++sample) {
      const VectorXd q = random_values(random, n), qdd = random_rates(random, n);
      VectorXd qd = random_rates(random, n);
      if (sample % 4 == 0) qd.setZero();  // as where forces are measured at rest
      const MatrixXd Y = dynamics_regressor(robot, q, qd, qdd);
      const MatrixXd Y_base = Y(Eigen::all, base.columns);
      stacked.middleRows(sample * n, n) = Y_base;
      const VectorXd tau = Y * p;
      CHECK((Y_base * p_base - tau).norm() < 1e-9 * (1.0 + tau.norm()));
      // The same for parameters that no body has.
      const VectorXd any = random_values(random, static_cast<int>(p.size()));
      const VectorXd forces = Y * any;
      CHECK((Y_base * (base.grouping * any) - forces).norm() < 1e-8 * (1.0 + forces.norm()));
    }
    if (stacked.rows() <= kMostDecomposed) CHECK(rank(stacked) == stacked.cols());
  }
}

// The weight of what slides, 2 kg * 9.81 m/s^2, and its dry friction of 3 N: one column each, since
// at rest only the weight acts.
TEST_CASE("dry friction of a joint along gravity is separated from its weight at rest") {
  RobotSpec spec;
  Joint joint;
  joint.kind = JointKind::kPrismatic;
  spec.joints.push_back(joint);
  Link link;
  link.mass = 2.0;
  link.friction = {.coulomb_plus = 3.0, .coulomb_minus = -3.0};
  spec.links.push_back(link);
  spec.gravity = {0.0, 0.0, -9.81};
  const Robot robot(spec);
  const BaseParameters base = base_parameters(robot);
  const VectorXd values = base.grouping * dynamic_parameters(robot);
  const VectorXd q = VectorXd::Constant(1, 0.2), none = VectorXd::Zero(1);
  for (const auto& [speed, force] : {std::pair{0.5, 22.62}, {-0.5, 16.62}, {0.0, 19.62}}) {
    const VectorXd qd = VectorXd::Constant(1, speed);
    const MatrixXd Y = dynamics_regressor(robot, q, qd, none);
    CHECK((Y(Eigen::all, base.columns) * values)[0] == doctest::Approx(force));
    CHECK(inverse_dynamics(robot, q, qd, none)[0] == doctest::Approx(force));
  }
}

// 7 for a revolute joint and 4 for a prismatic one, less 3, less 1 if the first is revolute, less
// 2 more if its axis is vertical; fewer where a link cannot rotate in all directions. M. Gautier,
// W. Khalil, Direct calculation of minimum set of inertial parameters of serial robots, IEEE
// Transactions on Robotics and Automation 6(3), 1990.
TEST_CASE("an arm has as many base parameters as the formula says, a special one fewer") {
  Random random(15);
  for (int k = 0; k < 60; ++k) {
    const bool may_slide = k % 3 == 0;
    const Robot robot = general_arm(random, 1 + k % 6, may_slide);
    Index expected = -3;
    for (int i = 0; i < robot.n(); ++i)
      expected += robot.joint(i).kind == JointKind::kRevolute ? 7 : 4;
    if (robot.joint(0).kind == JointKind::kRevolute) {
      const bool is_upright = robot.spec().convention == DhConvention::kStandard;
      expected -= is_upright && robot.gravity().head<2>().norm() == 0.0 ? 3 : 1;
    }
    const Index found = mass_columns(base_parameters(robot));
    if (may_slide) {
      CHECK(found <= expected);
    } else {
      CHECK(found == expected);
    }
  }
}

// Gautier and Khalil 1990; H. Mayeda, K. Yoshida, K. Osuka, Base parameters of manipulator dynamic
// models, IEEE Transactions on Robotics and Automation 6(3), 1990.
TEST_CASE("a Puma 560 has 36 base parameters of its masses") {
  CHECK(mass_columns(base_parameters(*make_robot("puma560"))) == 36);
}

TEST_CASE("bad arguments of the regressor are reported") {
  const Robot robot = *make_robot("scara");
  const VectorXd zero = VectorXd::Zero(4);
  CHECK_THROWS_AS(dynamics_regressor(robot, VectorXd::Zero(3), zero, zero), ArgumentError);
  CHECK_THROWS_AS(dynamics_regressor(robot, zero, VectorXd::Constant(4, 1e200), zero),
                  ArgumentError);
}
