#include "armlet/trajectory/velocity.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

struct State {
  Eigen::VectorXd q, qd, qdd;
};

State state_at(const Trajectory& motion, double t) {
  State state{Eigen::VectorXd(motion.n()), Eigen::VectorXd(motion.n()),
              Eigen::VectorXd(motion.n())};
  motion.sample(t, state.q, state.qd, state.qdd);
  return state;
}

// From where the motion is when its time of giving speeds ends.
void go_on(const Trajectory& motion, VelocityStart& start) {
  State next = state_at(motion, start.during);
  start.q = std::move(next.q);
  start.qd = std::move(next.qd);
  start.qdd = std::move(next.qdd);
}

// Whether it starts as given, ends at rest, and keeps to every limit in between, without a jump of
// an acceleration.
void check_motion(const Robot& robot, const VelocityStart& start, const Trajectory& motion) {
  CHECK((motion.start() - start.q).norm() == 0.0);
  CHECK((state_at(motion, 0.0).qd - start.qd).norm() < 1e-9);
  CHECK(state_at(motion, motion.duration()).qd.norm() < 1e-9);
  if (start.qdd.size() > 0) CHECK((state_at(motion, 0.0).qdd - start.qdd).norm() < 1e-9);
  for (int i = 0; i < robot.n(); ++i) {
    CHECK(motion.peak(i, 1) <= robot.max_speed()[i] * (1.0 + 1e-9));
    CHECK(motion.peak(i, 2) <= robot.max_accel()[i] * (1.0 + 1e-9));
    CHECK(motion.peak(i, 3) <= robot.max_jerk()[i] * (1.0 + 1e-9));
    const Trajectory::Start taken_over = Trajectory::Start::kMoving;
    CHECK(motion.continuity(i, 1e-7, taken_over) >= 2);
    CHECK(motion.range(i).upper <= robot.upper()[i] + 1e-9);
    CHECK(motion.range(i).lower >= robot.lower()[i] - 1e-9);
  }
}

}  // namespace

// A change of speed by v with acceleration a and jerk j takes v / a + a / j if a is reached, else
// 2 sqrt(v / j); half of that times v is the way.
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

TEST_CASE("the hand moves with the velocity asked for while the joints turn") {
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

TEST_CASE("velocities of the hand follow one another without a jump of an acceleration") {
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
