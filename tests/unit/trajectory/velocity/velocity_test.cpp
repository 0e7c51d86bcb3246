#include "armlet/trajectory/velocity.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"
#include "survey.hpp"
#include "velocity_cases.hpp"

using namespace armlet;
using namespace armlet::velocity_cases;

// A change of speed by v with acceleration a and jerk j takes v / a + a / j if a is reached, else
// 2 sqrt(v / j); half of that times v is the distance.
TEST_CASE("joint speeds are taken up as fast as accelerations and jerks allow and held") {
  const Robot robot = *make_robot("scara");
  const VelocityStart start{.q = robot.home(), .qd = Eigen::VectorXd::Zero(4), .during = 1.0};
  const Eigen::Vector4d rates(0.5, -0.25, 0.0, 0.1);
  const VelocityPlan plan = plan_joint_velocity(robot, start, rates);
  REQUIRE(plan.motion);
  check_motion(robot, start, *plan.motion);
  const double a = 1.0 / (rates.array().abs() / robot.max_accel().array()).maxCoeff();
  const double j = 1.0 / (rates.array().abs() / robot.max_jerk().array()).maxCoeff();
  const double ramp = j >= a * a ? 1.0 / a + a / j : 2.0 * std::sqrt(1.0 / j);
  CHECK(plan.motion->duration() == doctest::Approx(1.0 + ramp).epsilon(1e-12));
  CHECK((state_at(*plan.motion, 1.0).qd - rates).norm() < 1e-12);
  // The ramp costs half of its time.
  const Eigen::VectorXd way = state_at(*plan.motion, 1.0).q - start.q;
  CHECK((way - rates * (1.0 - 0.5 * ramp)).norm() < 1e-12);
}

TEST_CASE("commands follow one another without a step, whatever their speeds") {
  const Robot robot = *make_robot("puma560");
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  VelocityStart start{.q = robot.home(),
                      .qd = Eigen::VectorXd::Zero(6),
                      .qdd = Eigen::VectorXd::Zero(6),
                      .during = 0.04};
  int planned = 0;
  for (int k = 0; k < 2000; ++k) {
    Eigen::VectorXd rates(6);
    for (double& rate : rates) rate = unit(random);
    rates = rates.cwiseProduct(robot.max_speed());
    const VelocityPlan plan = plan_joint_velocity(robot, start, rates);
    if (!plan.motion) {  // it would run into a limit: brake instead, which always is possible
      REQUIRE(plan.outside);
      const VelocityPlan stop = plan_joint_velocity(robot, start, Eigen::VectorXd::Zero(6));
      REQUIRE(stop.motion);
      go_on(*stop.motion, start);
      continue;
    }
    ++planned;
    check_motion(robot, start, *plan.motion);
    go_on(*plan.motion, start);
  }
  CHECK(planned > 500);
}

TEST_CASE("the tool moves with the requested velocity while the joints rotate") {
  const Robot robot = *make_robot("puma560");
  const Eigen::VectorXd q = (Eigen::VectorXd(6) << 0.1, 0.8, 0.3, 0.2, 0.7, 0.1).finished();
  const VelocityStart start{.q = q, .qd = Eigen::VectorXd::Zero(6), .during = 0.8};
  Vector6d twist;
  twist << 0.05, -0.04, 0.03, 0.1, -0.05, 0.08;
  const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
  REQUIRE(plan.motion);
  check_motion(robot, start, *plan.motion);
  for (const double t : {0.3, 0.5123, 0.7, 0.8}) {
    const State state = state_at(*plan.motion, t);
    CHECK((jacobian(robot, state.q) * state.qd - twist).norm() < 1e-7);
  }
}

TEST_CASE("velocities of the tool follow one another without a jump of an acceleration") {
  const Robot robot = *make_robot("puma560");
  const Eigen::VectorXd q = (Eigen::VectorXd(6) << 0.1, 0.8, 0.3, 0.2, 0.7, 0.1).finished();
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  VelocityStart start{
      .q = q, .qd = Eigen::VectorXd::Zero(6), .qdd = Eigen::VectorXd::Zero(6), .during = 0.05};
  int planned = 0;
  for (int k = 0; k < 60; ++k) {
    Vector6d twist;
    for (double& v : twist) v = 0.05 * unit(random);
    const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
    if (!plan.motion) continue;  // some changes are too great for the joints
    ++planned;
    check_motion(robot, start, *plan.motion);
    go_on(*plan.motion, start);
  }
  CHECK(planned > 50);
}

TEST_CASE("what an arm cannot do is refused with the reason") {
  const Robot robot = *make_robot("scara");
  const VelocityStart start{.q = robot.home(), .qd = Eigen::VectorXd::Zero(4), .during = 1.0};
  Eigen::Vector4d rates(2.0 * robot.max_speed()[0], 0.0, 0.0, 0.0);
  const VelocityPlan fast = plan_joint_velocity(robot, start, rates);
  REQUIRE(fast.too_high);
  CHECK(fast.too_high->joint == 0);
  CHECK(fast.too_high->value == doctest::Approx(2.0 * fast.too_high->limit));

  VelocityStart longer = start;
  longer.during = 60.0;
  rates[0] = 1.0;
  const VelocityPlan far = plan_joint_velocity(robot, longer, rates);
  REQUIRE(far.outside);
  CHECK(far.outside->joint == 0);

  Vector6d tilt = Vector6d::Zero();
  tilt[3] = 0.5;
  const VelocityPlan lacking = plan_tool_velocity(robot, start, tilt);
  CHECK_FALSE(lacking.motion);
  CHECK(lacking.lacking == doctest::Approx(1.0));
}

// Found among other seeds: a loop v = k (goal - p) that has all but reached its goal asks for what
// rounding leaves, which no arm with fewer than six joints can give.
TEST_CASE("a velocity that lacks no more than rounding is not refused") {
  const Robot robot = *make_robot("scorbot");
  Dice dice{std::mt19937_64(57)};
  VelocityStart start = standing(good_position(robot, dice), 0.04);
  Vector6d twist = Vector6d::Zero();
  twist[2] = 1e-8;
  for (const double aside : {1e-13, 1e-11, 9e-10}) {
    twist.head<2>().setConstant(0.5 * aside);
    CHECK(plan_tool_velocity(robot, start, twist).motion.has_value());
  }
  twist[0] = twist[1] = 1e-7;
  const VelocityPlan refused = plan_tool_velocity(robot, start, twist);
  CHECK_FALSE(refused.motion.has_value());
  CHECK(refused.lacking > 0.1);
}

TEST_CASE("velocity commands reject sizes that differ, numbers that are none, and no time") {
  const Robot robot = *make_robot("scara");
  VelocityStart start{.q = robot.home(), .qd = Eigen::VectorXd::Zero(4), .during = 1.0};
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(4);
  CHECK_THROWS_AS(static_cast<void>(plan_joint_velocity(robot, start, Eigen::VectorXd::Zero(3))),
                  ArgumentError);
  Eigen::VectorXd undefined = none;
  undefined[1] = std::nan("");
  CHECK_THROWS_AS(static_cast<void>(plan_joint_velocity(robot, start, undefined)), ArgumentError);
  start.during = 0.0;
  CHECK_THROWS_AS(static_cast<void>(plan_joint_velocity(robot, start, none)), ArgumentError);
  CHECK_THROWS_AS(static_cast<void>(plan_tool_velocity(robot, start, Vector6d::Zero())),
                  ArgumentError);
}

TEST_CASE("joint speeds sent again and again move every arm like speeds sent once") {
  Dice dice{std::mt19937_64(survey_seed(50))};
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    const Resent result =
        resend(dice, standing(good_position(robot, dice), 0.0), 60, [&](const VelocityStart&) {
          Eigen::VectorXd rates = dice.within(0.5 * robot.max_speed());
          return [&robot, rates](const VelocityStart& from) {
            return plan_joint_velocity(robot, from, rates);
          };
        });
    CHECK(result.compared > 20);
    CHECK(result.apart < 1e-9);
  }
}

TEST_CASE("a velocity of the tool sent again and again moves every arm like one sent once") {
  Dice dice{std::mt19937_64(survey_seed(51))};
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    if (holdable(robot, 1.0, dice).isZero()) continue;
    for (int k = 0; k < 4; ++k) {
      const VelocityStart start = standing(good_position(robot, dice), 0.0);
      const Resent result = resend(dice, start, 6, [&](const VelocityStart&) {
        const Vector6d twist = holdable(robot, 0.15, dice);
        return [&robot, twist](const VelocityStart& from) {
          return plan_tool_velocity(robot, from, twist);
        };
      });
      CHECK(result.compared > 1);
      CHECK(result.apart < 1e-9);
    }
  }
}

TEST_CASE("no tool is faster than the fastest velocity that is still being taken up") {
  Dice dice{std::mt19937_64(survey_seed(52))};
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    if (holdable(robot, 1.0, dice).isZero()) continue;
    for (int k = 0; k < 3; ++k) {
      VelocityStart start = standing(good_position(robot, dice), 0.0);
      double fastest = 0.0, reached = 0.0;
      for (int c = 0; c < 12; ++c) {
        Vector6d twist = holdable(robot, 0.1, dice);
        if (robot.n() >= 6) twist.tail<3>().setZero();
        start.during = std::min(some_period(dice), 0.05);
        const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
        if (!plan.motion) break;
        fastest = std::max(fastest, twist.head<3>().norm());
        for (int i = 0; i <= 10; ++i) {
          const State s = state_at(*plan.motion, start.during * i / 10);
          const Vector6d moving = jacobian(robot, s.q) * s.qd;
          reached = std::max(reached, moving.head<3>().norm() / fastest);
        }
        check_motion(robot, start, *plan.motion);
        go_on(*plan.motion, start);
      }
      CHECK(reached > 0.0);
      CHECK(reached < 1.01);
    }
  }
}

// The report that led to the law: beats of 20 ms made the tool swing between -0.046 and 0.148 m/s.
TEST_CASE("short beats of one velocity of the tool take it up without swinging") {
  const Robot robot = *make_robot("puma560");
  Dice dice{std::mt19937_64(53)};
  const Eigen::VectorXd q = good_position(robot, dice);
  Vector6d twist = Vector6d::Zero();
  twist[0] = 0.05;
  for (const double beat : {0.001, 0.005, 0.02, 0.04}) {
    CAPTURE(beat);
    VelocityStart start = standing(q, beat);
    double before = 0.0;
    for (double t = 0.0; t < 0.4; t += beat) {
      const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
      REQUIRE(plan.motion);
      go_on(*plan.motion, start);
      const Vector6d moving = jacobian(robot, start.q) * start.qd;
      CHECK(moving[0] >= before - 1e-9);
      CHECK(moving[0] <= 0.05 + 1e-9);
      before = moving[0];
    }
    CHECK(before == doctest::Approx(0.05).epsilon(1e-9));
  }
}

// A joint needs the acceleration k^2 d and the jerk k^3 d for a joint distance of d: with a tenth
// of what it has, the delay of the take-up is small beside 1 / k.
TEST_CASE("a loop v = k (goal - p) brings every tool to its goal without going past it") {
  Dice dice{std::mt19937_64(survey_seed(54))};
  double farthest_past = 0.0, most_left = 0.0;
  int loops = 0;
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    if (holdable(robot, 1.0, dice).isZero()) continue;
    for (int n = 0; n < 3 * survey_count(1); ++n) {
      const double beat = std::array{0.01, 0.02, 0.04}[static_cast<std::size_t>(n % 3)];
      const double k = dice.from(1.0, 10.0);
      CAPTURE(beat);
      CAPTURE(k);
      VelocityStart start = standing(good_position(robot, dice), beat);
      Vector6d towards = holdable(robot, 1.0, dice);
      towards.tail<3>().setZero();
      towards /= towards.norm();
      const Eigen::MatrixXd J = jacobian(robot, start.q);
      const Eigen::VectorXd per_metre = J.completeOrthogonalDecomposition().solve(towards);
      const Eigen::ArrayXd joints = per_metre.array().abs().max(1e-9);
      const double distance =
          std::min({0.03, (0.1 * robot.max_accel().array() / joints).minCoeff() / (k * k),
                    (0.1 * robot.max_jerk().array() / joints).minCoeff() / (k * k * k)});
      const Eigen::Vector3d goal =
          forward(robot, start.q).translation() + distance * towards.head<3>();
      double past = 0.0;
      Eigen::Vector3d left = distance * towards.head<3>();
      for (double t = 0.0; t < 10.0 / k + 0.5; t += beat) {
        Vector6d twist = Vector6d::Zero();
        twist.head<3>() = k * left;
        const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
        CAPTURE(t);
        CAPTURE(distance);
        CAPTURE(plan.lacking);
        CAPTURE(plan.outside.has_value());
        CAPTURE(plan.too_high ? plan.too_high->value / plan.too_high->limit : 0.0);
        REQUIRE(plan.motion);
        go_on(*plan.motion, start);
        left = goal - forward(robot, start.q).translation();
        past = std::max(past, -left.dot(towards.head<3>()));
      }
      CHECK(past <= 0.02 * distance);
      CHECK(left.norm() <= 1e-3 * distance);
      farthest_past = std::max(farthest_past, past / distance);
      most_left = std::max(most_left, left.norm() / distance);
      ++loops;
    }
  }
  MESSAGE(loops << " loops, at most " << 100.0 * farthest_past << " % past the goal, "
                << 100.0 * most_left << " % left");
}
