#include "armlet/trajectory/damped_line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "motions.hpp"

using namespace armlet;

namespace {

const Robot kArm = *make_robot("ur5");

Eigen::VectorXd joints(std::initializer_list<double> values) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(values.size()));
  std::ranges::copy(values, q.begin());
  return q;
}

// The largest distance of the tool from the straight line between two positions, over the motion.
double largest_deviation(const Trajectory& motion, const Eigen::Isometry3d& T_0,
                         const Eigen::Isometry3d& T_1) {
  double largest = 0.0;
  const Eigen::Vector3d way = T_1.translation() - T_0.translation();
  for (int k = 0; k <= 5000; ++k) {
    const Eigen::Isometry3d T = tool_at(kArm, motion, k * motion.duration() / 5000.0);
    const Eigen::Vector3d off = T.translation() - T_0.translation();
    const double s = std::clamp(off.dot(way) / way.squaredNorm(), 0.0, 1.0);
    largest = std::max(largest, (off - s * way).norm());
  }
  return largest;
}

LineMove along_y(const Eigen::VectorXd& q0, double distance) {
  LineMove move{.q0 = q0, .T_world_goal = forward(kArm, q0)};
  move.T_world_goal.translation().y() += distance;
  return move;
}

}  // namespace

TEST_CASE("away from singularities the damped line is the line") {
  const LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.2);
  const DampedLine damped = plan_damped_line(kArm, move, 0.02);
  const LinePlan exact = plan_line(kArm, move);
  REQUIRE(damped.ok());
  REQUIRE(exact.ok());
  CHECK(damped.deviation < 1e-6);
  CHECK(damped.length == doctest::Approx(exact.length).epsilon(1e-9));
  CHECK(damped.motion.trajectory->duration() < exact.motion.trajectory->duration());
  LineMove slower = move;
  slower.speed = 0.5;
  CHECK(plan_damped_line(kArm, slower, 0.02).motion.trajectory->duration() ==
        doctest::Approx(2.0 * damped.motion.trajectory->duration()).epsilon(1e-9));
  LineMove timed = move;
  timed.time = 5.0;
  CHECK(plan_damped_line(kArm, timed, 0.02).motion.trajectory->duration() == doctest::Approx(5.0));
  timed.time = 0.01;
  const DampedLine fast = plan_damped_line(kArm, timed, 0.02);
  CHECK_FALSE(fast.ok());
  CHECK(fast.motion.too_fast->least_time == doctest::Approx(damped.motion.trajectory->duration()));
  timed.enforce_limits = false;
  CHECK(plan_damped_line(kArm, timed, 0.02).motion.trajectory->duration() == doctest::Approx(0.01));
}

// The wrist of the arm passes q5 = 0, where the fourth and the sixth axis are parallel.
TEST_CASE(
    "past a singular wrist no line can be followed; the damped one runs and says how far it "
    "strays") {
  const Eigen::VectorXd q0 = joints({-0.6, -1.3, 1.9, -1.1, -0.35, 0.2});
  LineMove move{.q0 = q0, .T_world_goal = forward(kArm, q0)};
  // A rotation that takes the wrist close to its singularity.
  Eigen::VectorXd beyond = q0;
  beyond[4] = 0.35;
  beyond[3] += 0.1;
  move.T_world_goal = forward(kArm, beyond);
  const LinePlan exact = plan_line(kArm, move);
  const DampedLine damped = plan_damped_line(kArm, move, 0.1);
  REQUIRE(damped.ok());
  CHECK(damped.deviation > 1e-5);
  CHECK(damped.deviation < 0.05);
  REQUIRE(exact.fault);
  CHECK(exact.fault->kind != LineFaultKind::kGoal);
  // Behind the singularity it catches up, and arrives.
  const Eigen::Isometry3d T_end = forward(kArm, damped.motion.trajectory->end());
  CHECK((T_end.translation() - move.T_world_goal.translation()).norm() < 1e-6);
  CHECK(angle_between(T_end, move.T_world_goal) < 1e-5);
  // The tool keeps its speed also where it catches up with the line.
  move.tool_speed = 0.02;
  const DampedLine careful = plan_damped_line(kArm, move, 0.1);
  REQUIRE(careful.ok());
  const Trajectory& motion = *careful.motion.trajectory;
  const auto place = [&](double t) {
    return Eigen::Vector3d(tool_at(kArm, motion, t).translation());
  };
  for (int k = 1; k < 1000; ++k) {
    const double t = motion.duration() * k / 1000.0;
    CHECK((place(t + 1e-4) - place(t - 1e-4)).norm() / 2e-4 < 0.02 * 1.02);
  }
  // The distance from the line is part of the deviation from where the tool should be.
  const double aside =
      largest_deviation(*damped.motion.trajectory, forward(kArm, q0), move.T_world_goal);
  CHECK(aside <= damped.deviation * (1.0 + 1e-6));
  CHECK(aside > 0.3 * damped.deviation);
}

TEST_CASE("damped lines of many arms keep all limits, also through singularities") {
  std::mt19937_64 generator(5);
  int made = 0, left = 0;
  for (const char* name :
       {"puma560", "irb120", "panda", "stanford", "planar2", "anthropomorphic"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 4; ++k) {
      CAPTURE(k);
      Eigen::VectorXd q = joints_near_home(robot, generator, 0.4);
      if (k % 2 == 1 && robot.n() == 6) q[4] = 0.02;  // the wrist is almost stretched
      LineMove move{.q0 = q,
                    .T_world_goal = forward(robot, q),
                    .task = robot.n() < 6 ? IkTask::kPositionFirst : IkTask::kPose};
      for (int i = 0; i < 3; ++i)
        move.T_world_goal.translation()[i] += uniform(generator, -0.2, 0.2);
      const DampedLine plan = plan_damped_line(robot, move);
      if (!plan.ok()) continue;
      ++made;
      if (plan.deviation > 1e-3) ++left;
      const Trajectory& motion = *plan.motion.trajectory;
      for (int i = 0; i < robot.n(); ++i) {
        CHECK(motion.continuity(i, 1e-6) >= 2);
        CHECK(motion.peak(i, 1) <= robot.max_speed()[i] * (1.0 + 1e-8));
        CHECK(motion.peak(i, 2) <= robot.max_accel()[i] * (1.0 + 1e-8));
        CHECK(motion.peak(i, 3) <= robot.max_jerk()[i] * (1.0 + 1e-8));
      }
    }
  }
  CHECK(made >= 15);
  CHECK(left >= 5);
}

TEST_CASE("a damping that is not above zero and a goal without orientation are refused") {
  LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.1);
  CHECK_THROWS_AS((void)plan_damped_line(kArm, move, 0.0), ArgumentError);
  move.task = IkTask::kHeading;
  CHECK_THROWS_AS((void)plan_damped_line(kArm, move), ArgumentError);
}

TEST_CASE("arms with fewer joints follow the position alone; the stretched arm falls short of it") {
  const Robot arm = *make_robot("planar2");  // two links of 1 m
  const Eigen::VectorXd q0 = joints({0.2, 0.9});
  LineMove move{
      .q0 = q0, .T_world_goal = forward(arm, joints({0.1, 1.2})), .task = IkTask::kPositionFirst};
  const DampedLine inside = plan_damped_line(arm, move);
  REQUIRE(inside.ok());
  CHECK(inside.deviation < 1e-6);
  CHECK(inside.angle == 0.0);
  // 2.1 m from the base: a tenth of a metre beyond its reach.
  const Eigen::Vector3d axis = arm.T_world_base().translation();
  Eigen::Vector3d out = move.T_world_goal.translation() - axis;
  out *= 2.1 / out.norm();
  move.T_world_goal.translation() = axis + out;
  const DampedLine beyond = plan_damped_line(arm, move);
  REQUIRE(beyond.ok());
  CHECK(beyond.deviation == doctest::Approx(0.1).epsilon(0.02));
  CHECK(beyond.at == doctest::Approx(1.0));
}

TEST_CASE("a damped arc is the arc where nothing is singular, and none where there is none") {
  LineMove move = along_y(joints({-0.3, -1.3, 1.9, -1.1, -1.5, 0.2}), 0.2);
  const Eigen::Vector3d start = forward(kArm, move.q0).translation();
  const Eigen::Vector3d via = start + Eigen::Vector3d(0.03, 0.1, 0.0);
  const auto arc = plan_damped_arc(kArm, via, move);
  REQUIRE(arc);
  REQUIRE(arc->ok());
  CHECK(arc->deviation < 1e-6);
  CHECK(arc->length == doctest::Approx(plan_arc(kArm, via, move).length).epsilon(1e-9));
  CHECK_FALSE(plan_damped_arc(kArm, start - Eigen::Vector3d(0.0, 0.1, 0.0), move));
}
