// The fastest run under what motors give.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "motor_arms.hpp"
#include "paths.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

constexpr double kFree = std::numeric_limits<double>::infinity();

// One joint of 2 kg m^2 without gravity, whose motor gives 3 N m.
RobotSpec wheel() {
  RobotSpec spec;
  spec.joints.push_back({.max_effort = 3.0});
  spec.links.push_back({.mass = 1.0, .inertia = 2.0 * Eigen::Matrix3d::Identity()});
  return spec;
}

// The share of its limit that each force and speed takes at t: the largest.
double load(const Robot& robot, const std::vector<AxisLimits>& limits, const Trajectory& motion,
            double t) {
  VectorXd q(robot.n()), qd(robot.n()), qdd(robot.n());
  motion.sample(t, q, qd, qdd);
  const JointVector tau = inverse_dynamics(robot, q, qd, qdd);
  double most = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    most = std::max({most, std::abs(tau[i]) / robot.joint(i).max_effort, std::abs(qd[i]) / l.speed,
                     std::abs(qdd[i]) / l.acceleration});
  }
  return most;
}

double fastest(const RobotSpec& spec, double length, double speed) {
  const std::vector<AxisLimits> limits{{speed, kFree}};
  const auto motion = time_optimal_with_motors(Robot(spec), straight_line(length), limits, 400);
  REQUIRE(motion);
  return motion->duration();
}

// The integral of f from 0 to v.
template <class F>
double integral(double v, F f) {
  constexpr int kParts = 2000;
  double sum = f(0.0) + f(v);
  for (int k = 1; k < kParts; ++k) sum += (k % 2 == 0 ? 2.0 : 4.0) * f(v * k / kParts);
  return sum * v / (3.0 * kParts);
}

std::vector<AxisLimits> free_limits(Random& random, int n) {
  std::vector<AxisLimits> limits;
  for (int i = 0; i < n; ++i) limits.push_back({random.uniform(1.0, 6.0), kFree});
  return limits;
}

}  // namespace

TEST_CASE("a joint that nothing else loads is as fast as torque over inertia allows") {
  // A = 1.5 rad/s^2, to V = 1 rad/s and without coming to it.
  CHECK(fastest(wheel(), 2.0, 1.0) == doctest::Approx(2.0 + 1.0 / 1.5).epsilon(1e-5));
  CHECK(fastest(wheel(), 0.3, 1.0) == doctest::Approx(2.0 * std::sqrt(0.3 / 1.5)).epsilon(1e-5));
}

// Against dry and viscous friction a joint gains speed as v' = (3 - 0.5 - 0.8 v) / 2 and loses it
// as v' = -(3 + 0.5 + 0.8 v) / 2; the switch is where both parts together are as long as the path.
TEST_CASE("friction slows the start and helps to stop") {
  RobotSpec spec = wheel();
  spec.links[0].friction = {.viscous = 0.8, .coulomb_plus = 0.5, .coulomb_minus = -0.5};
  const auto gain = [](double v) { return (2.5 - 0.8 * v) / 2.0; };
  const auto loss = [](double v) { return (3.5 + 0.8 * v) / 2.0; };
  double low = 0.0, high = 2.5 / 0.8;
  for (int k = 0; k < 60; ++k) {
    const double v = 0.5 * (low + high);
    const double way = integral(v, [&](double x) { return x / gain(x) + x / loss(x); });
    (way < 1.5 ? low : high) = v;
  }
  const double T = integral(low, [&](double x) { return 1.0 / gain(x) + 1.0 / loss(x); });
  const double found = fastest(spec, 1.5, 100.0);
  CHECK(found >= T * (1.0 - 1e-9));
  CHECK(found <= T * 1.005);
}

TEST_CASE("what motors give holds everywhere, for every kind of friction") {
  Random random(5);
  std::mt19937_64 generator(6);
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const int n = 1 + k % 6;
    const Trajectory path = random_path(generator, n, 6);
    const Robot robot = arm_for(random, path, static_cast<Rub>(k % 3));
    const std::vector<AxisLimits> limits = free_limits(random, n);
    const auto motion = time_optimal_with_motors(robot, path, limits, 100);
    if (!motion) continue;
    double most = 0.0;
    for (int sample = 0; sample < 4000; ++sample) {
      const double t = motion->duration() * (sample + 0.5) / 4000.0;
      most = std::max(most, load(robot, limits, *motion, t));
    }
    CHECK(most <= 1.0 + 1e-6);
    CHECK(motion_forces(robot, *motion).slower <= 1.0 + 1e-9);
    CHECK((motion->end() - path.end()).norm() == 0.0);
  }
}

TEST_CASE("at nearly every moment some motor or some speed is at its limit") {
  Random random(7);
  std::mt19937_64 generator(8);
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    const int n = 1 + k % 6;
    const Trajectory path = random_path(generator, n, 6);
    const Robot robot = arm_for(random, path, k % 2 == 0 ? Rub::kNone : Rub::kDry);
    const std::vector<AxisLimits> limits = free_limits(random, n);
    const auto motion = time_optimal_with_motors(robot, path, limits, 400);
    REQUIRE(motion);
    int idle = 0;
    for (int sample = 1; sample < 1000; ++sample)
      idle += load(robot, limits, *motion, motion->duration() * sample / 1000.0) < 0.97 ? 1 : 0;
    CHECK(idle <= 60);
  }
}

TEST_CASE("stronger motors are never slower, and accelerations count where no motor is known") {
  Random random(9);
  std::mt19937_64 generator(10);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Trajectory path = random_path(generator, 3, 6);
    RobotSpec spec = arm_for(random, path, Rub::kDry).spec();
    std::vector<AxisLimits> limits = free_limits(random, 3);
    const auto before = time_optimal_with_motors(Robot(spec), path, limits, 200);
    REQUIRE(before);
    for (Joint& joint : spec.joints) joint.max_effort *= 1.2;
    const auto stronger = time_optimal_with_motors(Robot(spec), path, limits, 200);
    REQUIRE(stronger);
    CHECK(stronger->duration() <= before->duration() * (1.0 + 2e-3));
    spec.joints[1].max_effort = kFree;
    CHECK_THROWS_AS((void)time_optimal_with_motors(Robot(spec), path, limits, 200), ArgumentError);
    limits[1].acceleration = 2.0;
    const auto mixed = time_optimal_with_motors(Robot(spec), path, limits, 200);
    REQUIRE(mixed);
    CHECK(mixed->peak(1, 2) <= 2.0 * (1.0 + 1e-9));
  }
}

TEST_CASE("a path on which a motor cannot hold the arm has no run") {
  RobotSpec spec = wheel();
  spec.links[0].com = {0.5, 0.0, 0.0};
  spec.gravity = {0.0, -9.81, 0.0};  // across the axis: up to 4.9 N m
  const std::vector<AxisLimits> limits{{1.0, kFree}};
  CHECK_FALSE(time_optimal_with_motors(Robot(spec), straight_line(1.0), limits));
  spec.joints[0].max_effort = 5.2;
  CHECK(time_optimal_with_motors(Robot(spec), straight_line(1.0), limits));
  spec.links[0].friction = {.coulomb_plus = 0.4, .coulomb_minus = -0.4};
  CHECK_FALSE(time_optimal_with_motors(Robot(spec), straight_line(1.0), limits));
}

TEST_CASE("the planner Fastest of a Puma uses its motors, and a lower speed needs less of them") {
  const Robot puma = *make_robot("puma560");
  const PlannerSet planners;
  VectorXd by(6);
  by << 1.2, 0.3, 0.5, 0.5, 0.2, -0.4;
  JointMove move{.q0 = puma.home(), .q1 = puma.home() + by, .planner = "Fastest"};
  const MotionPlan by_acceleration = plan_joint_move(planners, puma, move);
  move.motors = &puma;
  const MotionPlan by_motors = plan_joint_move(planners, puma, move);
  REQUIRE(by_acceleration.ok());
  REQUIRE(by_motors.ok());
  CHECK(motion_forces(puma, *by_motors.trajectory).slower <= 1.0 + 1e-9);
  move.speed = 0.2;
  const MotionPlan slow = plan_joint_move(planners, puma, move);
  REQUIRE(slow.ok());
  CHECK(slow.trajectory->duration() > by_motors.trajectory->duration());
  for (int i = 0; i < 6; ++i)
    CHECK(slow.trajectory->peak(i, 1) <= 0.2 * puma.max_speed()[i] * (1.0 + 1e-6));
  move.speed.reset();
  move.time = 0.9 * by_motors.trajectory->duration();
  const MotionPlan hasty = plan_joint_move(planners, puma, move);
  CHECK_FALSE(hasty.ok());
  REQUIRE(hasty.too_fast);
  CHECK(hasty.too_fast->least_time == doctest::Approx(by_motors.trajectory->duration()));
}
