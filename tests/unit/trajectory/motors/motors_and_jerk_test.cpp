// Moves with limited jerk that motors limit instead of accelerations.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "armlet/trajectory/jerk_limited.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "motor_arms.hpp"
#include "paths.hpp"
#include "trajectory/timing/smooth_run.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// The largest share of its limit that a joint force takes, a thousand times a second.
double largest_share(const Robot& robot, const Trajectory& motion) {
  VectorXd q(robot.n()), qd(robot.n()), qdd(robot.n());
  double most = 0.0;
  for (double t = 0.0; t <= motion.duration(); t += 1e-3) {
    motion.sample(t, q, qd, qdd);
    const JointVector tau = inverse_dynamics(robot, q, qd, qdd);
    for (int i = 0; i < robot.n(); ++i)
      most = std::max(most, std::abs(tau[i]) / robot.joint(i).max_effort);
  }
  return most;
}

void check_rates(const Trajectory& motion, const std::vector<AxisLimits>& limits) {
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    CHECK(motion.peak(i, 1) <= l.speed * (1.0 + 1e-9));
    CHECK(motion.peak(i, 2) <= l.acceleration * (1.0 + 1e-9));
    CHECK(motion.peak(i, 3) <= l.jerk * (1.0 + 1e-9));
    CHECK(motion.continuity(i, 1e-7) >= 2);
  }
}

std::vector<AxisLimits> jerk_limits(Random& random, int n) {
  std::vector<AxisLimits> limits;
  for (int i = 0; i < n; ++i)
    limits.push_back({random.uniform(1.0, 4.0), kUnlimited, random.uniform(20.0, 300.0)});
  return limits;
}

// 2 kg m^2 without gravity, whose motor gives 3 N m: 1.5 rad/s^2.
Robot motor_wheel(double acceleration) {
  RobotSpec spec;
  spec.joints.push_back(
      {.max_speed = 2.0, .max_accel = acceleration, .max_jerk = 10.0, .max_effort = 3.0});
  spec.links.push_back({.mass = 1.0, .inertia = 2.0 * Eigen::Matrix3d::Identity()});
  return Robot(spec);
}

double time_of(const Robot& robot, double travel, const Robot* motors) {
  const JointMove move{.q0 = VectorXd::Zero(1),
                       .q1 = VectorXd::Constant(1, travel),
                       .planner = "SCurve",
                       .motors = motors};
  const MotionPlan plan = plan_joint_move(PlannerSet(), robot, move);
  REQUIRE(plan.ok());
  return plan.trajectory->duration();
}

}  // namespace

// An acceleration of 1.5 rad/s^2 is what the motor is, whatever maxAccel says.
TEST_CASE("a joint that nothing else loads moves as under the acceleration that its motor gives") {
  for (const double travel : {0.02, 0.3, 1.0, 3.0}) {
    CAPTURE(travel);
    const double least = time_of(motor_wheel(1.5), travel, nullptr);
    for (const double acceleration : {0.2, 1.5, 8.0}) {
      const Robot robot = motor_wheel(acceleration);
      const double T = time_of(robot, travel, &robot);
      CHECK(T >= least * (1.0 - 1e-9));
      CHECK(T <= least * 1.01);
    }
  }
}

TEST_CASE("along random paths motors, speeds and jerks are kept, for every kind of friction") {
  Random random(31);
  std::mt19937_64 generator(32);
  int ran = 0;
  double over = 0.0;
  for (int k = 0; k < 45; ++k) {
    CAPTURE(k);
    const int n = 1 + k % 6;
    const Trajectory path = random_path(generator, n, 6);
    const Robot robot = arm_for(random, path, static_cast<Rub>(k % 3));
    const std::vector<AxisLimits> limits = jerk_limits(random, n);
    const Course course{path, limits, {}, {}, &robot};
    const auto fastest = fastest_along(course, 200);
    if (!fastest) continue;
    const TimedRun run = smooth_run(course, *fastest, 96);
    if (run.s.empty()) continue;
    ++ran;
    check_rates(run.motion, limits);
    over = std::max(over, motion_forces(robot, run.motion).slower);
    CHECK(motion_forces(robot, run.motion).slower <= 1.01);
    CHECK(largest_share(robot, run.motion) <= 1.02);
    CHECK((run.motion.end() - path.end()).norm() == 0.0);
    // No run is faster than the one without limits on jerk.
    CHECK(run.motion.duration() >= fastest->duration() * (1.0 - 5e-3));
  }
  CHECK(ran >= 35);
  MESSAGE(ran << " runs, at most " << 100.0 * (over - 1.0) << " % too fast for motors");
}

TEST_CASE("without a limit on jerk that counts the run is that of motors alone") {
  Random random(33);
  std::mt19937_64 generator(34);
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    const Trajectory path = random_path(generator, 3, 5);
    const Robot robot = arm_for(random, path, k % 2 == 0 ? Rub::kNone : Rub::kDry);
    std::vector<AxisLimits> limits = jerk_limits(random, 3);
    for (AxisLimits& l : limits) l.jerk = 1e6;
    const auto least = time_optimal_with_motors(robot, path, limits, 400);
    REQUIRE(least);
    const Course course{path, limits, {}, {}, &robot};
    const TimedRun run = smooth_run(course, *fastest_along(course, 200), 400);
    REQUIRE(!run.s.empty());
    CHECK(run.motion.duration() <= least->duration() * 1.06);
  }
}

TEST_CASE("SCurve with motors keeps all limits and is never longer than slowed accelerations") {
  Random random(35);
  std::mt19937_64 generator(36);
  const PlannerSet planners;
  double shorter = 0.0;
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const int n = 1 + k % 6;
    VectorXd q0(n), q1(n);
    for (double& q : q0) q = random.uniform(-1.5, 1.5);
    for (double& q : q1) q = random.uniform(-1.5, 1.5);
    const std::vector<VectorXd> ends = {q0, q1};
    const Robot robot = arm_for(random, path_through(ends), static_cast<Rub>(k % 3));
    std::vector<AxisLimits> limits = jerk_limits(random, n);
    for (AxisLimits& l : limits) l.acceleration = random.uniform(1.0, 12.0);
    MoveRequest request{.q0 = q0, .q1 = q1, .limits = limits};
    const Plan plain = planners.plan("SCurve", request);
    request.motors = &robot;
    const Plan plan = planners.plan("SCurve", request);
    REQUIRE(plan.trajectory);
    const double slower = std::max(motion_forces(robot, *plain.trajectory).slower, 1.0);
    if (!std::isfinite(slower)) continue;
    CHECK(plan.trajectory->duration() <= plain.trajectory->duration() * slower * (1.0 + 1e-9));
    shorter = std::max(shorter,
                       1.0 - plan.trajectory->duration() / (plain.trajectory->duration() * slower));
    for (AxisLimits& l : limits) l.acceleration = kUnlimited;
    check_rates(*plan.trajectory, limits);
    CHECK(largest_share(robot, *plan.trajectory) <= 1.0 + 1e-4);
    CHECK((plan.trajectory->start() - q0).norm() == 0.0);
    CHECK((plan.trajectory->end() - q1).norm() == 0.0);
    // What speeds and jerks alone take is less than any motion takes.
    double least = 0.0;
    for (int i = 0; i < n; ++i) {
      AxisLimits l = limits[static_cast<std::size_t>(i)];
      l.acceleration = std::sqrt(l.speed * l.jerk);
      least = std::max(least, fastest_jerk_limited({.q = q0[i]}, q1[i], l).duration());
    }
    CHECK(plan.trajectory->duration() >= least * (1.0 - 1e-9));
    const Plan again = planners.plan("SCurve", request);
    CHECK(again.trajectory->duration() == plan.trajectory->duration());
  }
  CHECK(shorter > 0.2);
}

TEST_CASE("a fraction of the speed is kept, a longer time runs slower, a shorter one is refused") {
  const Robot panda = make_robot("panda")->with_payload({.mass = 3.0});
  const PlannerSet planners;
  JointMove move{.q0 = panda.home(), .q1 = panda.home(), .planner = "SCurve", .motors = &panda};
  move.q1.head<4>() += Eigen::Vector4d(0.9, 0.5, 0.4, 0.6);
  const MotionPlan fastest = plan_joint_move(planners, panda, move);
  REQUIRE(fastest.ok());
  const double T = fastest.trajectory->duration();
  move.speed = 0.2;
  const MotionPlan slow = plan_joint_move(planners, panda, move);
  REQUIRE(slow.ok());
  for (int i = 0; i < panda.n(); ++i)
    CHECK(slow.trajectory->peak(i, 1) <= 0.2 * panda.max_speed()[i] * (1.0 + 1e-6));
  CHECK(slow.trajectory->duration() > T);
  move.speed.reset();
  move.time = 1.3 * T;
  CHECK(plan_joint_move(planners, panda, move).trajectory->duration() ==
        doctest::Approx(1.3 * T).epsilon(1e-9));
  move.time = 0.9 * T;
  const MotionPlan hasty = plan_joint_move(planners, panda, move);
  CHECK_FALSE(hasty.ok());
  REQUIRE(hasty.too_fast);
  CHECK(hasty.too_fast->least_time == doctest::Approx(T));
}

TEST_CASE("paths of the tool with motors keep all limits and are never longer than without") {
  double most = 0.0;
  for (const char* name : {"puma560", "ur5", "panda", "iiwa14"}) {
    CAPTURE(name);
    const Robot robot = make_robot(name)->with_payload({.mass = 2.0});
    VectorXd q = robot.home();
    if (std::string(name) == "ur5") q << 0.0, -1.0, 1.5, -0.5, -1.5, 0.0;
    PathMove move{.q0 = q};
    const Eigen::Isometry3d T = forward(robot, q);
    for (const Eigen::Vector3d& by :
         {Eigen::Vector3d(-0.05, 0.12, 0.0), Eigen::Vector3d(-0.1, 0.12, -0.1),
          Eigen::Vector3d(-0.05, -0.08, -0.1)}) {
      Eigen::Isometry3d goal = T;
      goal.pretranslate(by);
      move.points.push_back({.T_world_tool = goal, .blend = 0.03});
    }
    for (const double speed : {1.0, 0.6}) {
      move.speed = speed;
      move.motors = nullptr;
      const PathPlan plain = plan_path(robot, move);
      move.motors = &robot;
      const PathPlan plan = plan_path(robot, move);
      REQUIRE(plain.ok());
      REQUIRE(plan.ok());
      const Trajectory& motion = *plan.motion.trajectory;
      const double slower = std::max(motion_forces(robot, *plain.motion.trajectory).slower, 1.0);
      CHECK(motion.duration() <= plain.motion.trajectory->duration() * slower * (1.0 + 1e-9));
      most = std::max(most, 1.0 - motion.duration() / plain.motion.trajectory->duration());
      std::vector<AxisLimits> limits = axis_limits(robot);
      for (AxisLimits& l : limits)
        l = {speed * l.speed, kUnlimited, speed * speed * speed * l.jerk};
      check_rates(motion, limits);
      CHECK(largest_share(robot, motion) <= 1.0 + 1e-4);
      CHECK(plan.times.back() == doctest::Approx(motion.duration()));
    }
  }
  CHECK(most > 0.05);
  MESSAGE("up to " << 100.0 * most << " % shorter");
}

TEST_CASE("where a motor cannot hold the arm the move is that of accelerations") {
  RobotSpec spec = motor_wheel(1.0).spec();
  spec.links[0].com = {0.5, 0.0, 0.0};
  spec.gravity = {0.0, -9.81, 0.0};  // across the axis: up to 4.9 N m
  const Robot weak(spec);
  CHECK(time_of(weak, 1.0, &weak) == doctest::Approx(time_of(weak, 1.0, nullptr)));
}
