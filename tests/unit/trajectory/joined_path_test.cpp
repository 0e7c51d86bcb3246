// Moves of the joints inside a path.

#include "trajectory/tool/joined_path.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "motions.hpp"

using namespace armlet;

namespace {

Eigen::Vector3d position_at(const Robot& robot, const Trajectory& motion, double t) {
  return tool_at(robot, motion, t).translation();
}

// How far joint values are from the straight line between two others, in the largest joint.
double off_line(const Eigen::VectorXd& q, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd way = b - a;
  const double part = way.dot(q - a) / way.squaredNorm();
  return (q - a - part * way).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE(
    "the length of a line of the joints is what the tool travels, or the equivalent of its "
    "rotation") {
  const Robot arm = *make_robot("planar2");
  Eigen::VectorXd q0(2), q1(2);
  q0 << 0.0, 0.5;
  q1 << 0.6, 0.5;  // about the first axis: an arc
  const double radius = forward(arm, q0).translation().norm();
  CHECK(joint_line(arm, q0, q1).duration() == doctest::Approx(0.6 * radius).epsilon(1e-9));
  CHECK(joint_line(arm, q0, q0).duration() == 0.0);

  const Robot puma = *make_robot("puma560");
  Eigen::VectorXd p0 = puma.home(), p1 = p0;
  p1[5] += 1.0;  // the tool rotates on the spot
  CHECK(joint_line(puma, p0, p1).duration() == doctest::Approx(0.2).epsilon(1e-9));
}

TEST_CASE("a blend along a line of the joints is what the tool travels there") {
  const Robot arm = *make_robot("ur5");
  std::mt19937_64 generator(3);
  for (int k = 0; k < 40; ++k) {
    const Trajectory line = joint_line(arm, joints_near_home(arm, generator, 0.4),
                                       joints_near_home(arm, generator, 0.4));
    const double blend = uniform(generator, 0.005, 0.05);
    for (const bool at_end : {false, true}) {
      const Trajectory path = at_end ? line.reversed() : line;
      const double r = at_end ? blend_at_end(arm, line, blend) : blend_at_start(arm, line, blend);
      CHECK(r <= blend);
      double travel = 0.0;
      constexpr int kChords = 2000;
      for (int j = 0; j < kChords; ++j) {
        travel += (position_at(arm, path, r * (j + 1) / kChords) -
                   position_at(arm, path, r * j / kChords))
                      .norm();
      }
      CHECK(travel <= blend * (1.0 + 1e-6));
      if (r < blend * 0.999) CHECK(travel == doctest::Approx(blend).epsilon(1e-5));
    }
  }
}

// Lines of the tool and of the joints in random order: every limit is kept, nothing jumps, and
// outside of the corners the arm is on its lines.
TEST_CASE("paths with moves of the joints keep their lines, their corners and all limits") {
  std::mt19937_64 generator(7);
  constexpr double kBlend = 0.02;
  int made = 0, corners = 0;
  for (const char* name : {"scara", "puma560", "ur5", "irb120", "panda", "stanford", "scorbot"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 6; ++k) {
      CAPTURE(k);
      Eigen::VectorXd q = joints_near_home(robot, generator, 0.4);
      PathMove move{.q0 = q, .task = robot.n() < 6 ? IkTask::kPositionFirst : IkTask::kPose};
      Eigen::Isometry3d T = forward(robot, q);
      std::vector<Eigen::VectorXd> at = {q};  // where joints are known, else empty
      for (int point = 0; point < 5; ++point) {
        if ((generator() >> 20) % 2 == 0) {
          q = joints_near_home(robot, generator, 0.4);
          T = forward(robot, q);
          move.points.push_back({.q = q, .blend = kBlend});
          at.push_back(q);
        } else {
          T.translation() +=
              Eigen::Vector3d(uniform(generator, -0.06, 0.06), uniform(generator, -0.06, 0.06),
                              uniform(generator, -0.06, 0.06));
          move.points.push_back({.T_world_tool = T, .blend = kBlend});
          at.push_back({});
        }
        if (k % 2 == 1) move.points.back().tool_speed = uniform(generator, 0.05, 0.2);
      }
      const PathPlan plan = plan_path(robot, move);
      if (!plan.ok()) continue;
      ++made;
      const Trajectory& motion = *plan.motion.trajectory;
      check_limits(robot, motion);
      if (at.back().size() > 0) CHECK((motion.end() - at.back()).cwiseAbs().maxCoeff() == 0.0);
      for (std::size_t p = 0; p < move.points.size(); ++p) {
        const double begin = p == 0 ? 0.0 : plan.times[p - 1], end = plan.times[p];
        CHECK(begin < end);
        const auto goal =
            move.points[p].q ? forward(robot, *move.points[p].q) : move.points[p].T_world_tool;
        if (p + 1 < move.points.size()) {
          ++corners;
          const double missed = (position_at(robot, motion, end) - goal.translation()).norm();
          CHECK(missed <= kBlend);
          CHECK(missed == doctest::Approx(plan.missed[p]).epsilon(1e-3).scale(1e-3));
        }
        if (at[p].size() > 0 && at[p + 1].size() > 0) {
          // From the middle between the corners.
          CHECK(off_line(joints_at(motion, 0.5 * (begin + end)), at[p], at[p + 1]) < 1e-9);
        }
      }
    }
  }
  CHECK(made >= 20);
  CHECK(corners >= 80);
}

TEST_CASE("the tool keeps its speed along moves of the joints, and never stops in between") {
  const Robot robot = *make_robot("ur5");
  Eigen::VectorXd q0(6), q1(6), q2(6);
  q0 << -0.3, -1.3, 1.9, -1.1, -1.5, 0.2;
  q1 << 0.4, -1.1, 1.6, -1.2, -1.4, 0.6;
  q2 << 0.9, -1.4, 1.9, -1.3, -1.2, 0.1;
  const PathPlan plan = plan_path(robot, {.q0 = q0,
                                          .points = {{.q = q1, .blend = 0.05, .tool_speed = 0.1},
                                                     {.q = q2, .tool_speed = 0.1}}});
  REQUIRE(plan.ok());
  const Trajectory& motion = *plan.motion.trajectory;
  const double T = motion.duration(), h = 1e-5;
  double fastest = 0.0, slowest = 1.0;
  for (int k = 1; k < 2000; ++k) {
    const double t = T * k / 2000.0;
    const double v =
        (position_at(robot, motion, t + h) - position_at(robot, motion, t - h)).norm() / (2.0 * h);
    fastest = std::max(fastest, v);
    if (t > 0.2 * T && t < 0.8 * T) slowest = std::min(slowest, v);
  }
  CHECK(fastest <= 0.1 * (1.0 + 1e-6));
  CHECK(fastest > 0.0999);
  CHECK(slowest > 0.08);
  // As long as the path at this speed, and what it takes to get there and back to rest.
  CHECK(T > plan.length / 0.1);
  CHECK(T < plan.length / 0.1 + 1.0);
}

TEST_CASE("without a blend the joints stop, as two moves one after the other do") {
  const Robot robot = *make_robot("puma560");
  const Eigen::VectorXd q0 = robot.home();
  Eigen::VectorXd q1 = q0, q2 = q0;
  q1[0] += 0.8;
  q2[1] -= 0.5;
  q2[0] += 1.1;
  const PathPlan plan = plan_path(robot, {.q0 = q0, .points = {{.q = q1}, {.q = q2}}});
  REQUIRE(plan.ok());
  const Trajectory& motion = *plan.motion.trajectory;
  CHECK((joints_at(motion, plan.times[0]) - q1).cwiseAbs().maxCoeff() < 1e-9);
  for (int i = 0; i < 6; ++i) CHECK(std::abs(motion.value(i, plan.times[0], 1)) < 1e-9);
  const MotionPlan alone =
      plan_joint_move(PlannerSet(), robot, {.q0 = q0, .q1 = q1, .planner = "Syn"});
  REQUIRE(alone.trajectory);
  CHECK(plan.times[0] <= alone.trajectory->duration());
}

TEST_CASE("a move of the joints to where they are adds nothing to a path") {
  const Robot robot = *make_robot("ur5");
  Eigen::VectorXd q0(6), q1(6);
  q0 << -0.3, -1.3, 1.9, -1.1, -1.5, 0.2;
  q1 << 0.4, -1.1, 1.6, -1.2, -1.4, 0.6;
  const PathPlan once = plan_path(robot, {.q0 = q0, .points = {{.q = q1}}});
  const PathPlan twice = plan_path(
      robot, {.q0 = q0, .points = {{.q = q0, .blend = 0.01}, {.q = q1, .blend = 0.01}, {.q = q1}}});
  REQUIRE(once.ok());
  REQUIRE(twice.ok());
  CHECK(once.motion.trajectory->duration() == twice.motion.trajectory->duration());
  CHECK(twice.times[2] == twice.times[1]);
  const PathPlan nothing = plan_path(robot, {.q0 = q0, .points = {{.q = q0}}});
  REQUIRE(nothing.ok());
  CHECK(nothing.motion.trajectory->duration() == 0.0);
}
