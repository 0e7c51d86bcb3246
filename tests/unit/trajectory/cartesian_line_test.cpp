#include "armlet/trajectory/cartesian_line.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "motions.hpp"

using namespace armlet;

namespace {

// Distance of a point from the line between two others.
double off_line(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = (b - a).normalized();
  return (p - a - (p - a).dot(along) * along).norm();
}

void check_line(const Robot& robot, const Trajectory& motion, const Eigen::Isometry3d& T_0,
                const Eigen::Isometry3d& T_1) {
  const double T = motion.duration();
  for (const double knot : motion.knots()) {
    const Eigen::Vector3d p = tool_at(robot, motion, knot).translation();
    CHECK(off_line(p, T_0.translation(), T_1.translation()) < 1e-9);
  }
  for (int k = 0; k <= 1000; ++k) {
    const double x = k / 1000.0;
    const double s = x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
    const Eigen::Isometry3d T_tool = tool_at(robot, motion, x * T);
    const Eigen::Isometry3d T_line = interpolate(T_0, T_1, s);
    // Looked at by the planner in the middle between samples, with something to spare.
    CHECK((T_tool.translation() - T_line.translation()).norm() < 1e-6);
    CHECK(angle_between(T_tool, T_line) < 1e-5);
  }
}

}  // namespace

TEST_CASE("the tool of a SCARA stays on the line, at samples and between") {
  const Robot robot = *make_robot("scara");
  const Eigen::Vector4d q0(0.61, 0.94, 0.11, -0.33);
  const Eigen::Isometry3d T_0 = forward(robot, q0);
  const Eigen::Isometry3d T_1 = forward(robot, Eigen::Vector4d(-0.2, 1.2, 0.05, 0.4));
  const LinePlan plan = plan_line(robot, {.q0 = q0, .T_world_goal = T_1, .time = 3.0});
  REQUIRE(plan.ok());
  CHECK(plan.motion.trajectory->duration() == 3.0);
  CHECK(plan.length == doctest::Approx((T_1.translation() - T_0.translation()).norm()));
  CHECK(plan.motion.trajectory->start() == q0);
  check_line(robot, *plan.motion.trajectory, T_0, T_1);
}

TEST_CASE("the tool of a PUMA follows random lines with an evenly rotating orientation") {
  const Robot robot = *make_robot("puma560");
  std::mt19937_64 generator(21);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53 - 0.5; };
  int followed = 0;
  for (int k = 0; k < 20; ++k) {
    Eigen::VectorXd q0(6);
    q0 << number(), 0.5 + 0.3 * number(), -0.4 + 0.3 * number(), number(), 0.8 + 0.4 * number(),
        number();
    const Eigen::Isometry3d T_0 = forward(robot, q0);
    Eigen::Isometry3d T_1 = T_0;
    T_1.translation() += 0.3 * Eigen::Vector3d(number(), number(), number());
    T_1.linear() = T_1.linear() * Eigen::AngleAxisd(number(), Eigen::Vector3d::UnitY()).matrix();
    const LinePlan plan = plan_line(robot, {.q0 = q0, .T_world_goal = T_1});
    if (!plan.ok()) {
      CHECK(plan.fault.has_value());
      continue;
    }
    ++followed;
    check_line(robot, *plan.motion.trajectory, T_0, T_1);
    for (int i = 0; i < 6; ++i) {
      CHECK(plan.motion.trajectory->peak(i, 1) <= robot.max_speed()[i] * (1.0 + 1e-9));
      CHECK(plan.motion.trajectory->peak(i, 2) <= robot.max_accel()[i] * (1.0 + 1e-9));
      CHECK(plan.motion.trajectory->peak(i, 3) <= robot.max_jerk()[i] * (1.0 + 1e-8));
      CHECK(std::abs(plan.motion.trajectory->value(i, 0.0, 1)) < 1e-9);
    }
  }
  CHECK(followed >= 15);
}

TEST_CASE("a position alone keeps the orientation; a rotation keeps the tilt") {
  const Robot robot = *make_robot("scara");
  const Eigen::Vector4d q0(0.4, 1.0, 0.1, 0.2);
  const Eigen::Isometry3d T_0 = forward(robot, q0);
  const Eigen::Vector3d goal(0.45, -0.1, 0.3);
  const LinePlan place = plan_line(
      robot, {.q0 = q0, .T_world_goal = make_translation(goal), .task = IkTask::kPositionFirst});
  REQUIRE(place.ok());
  const Eigen::Isometry3d T_1 = forward(robot, place.motion.trajectory->end());
  CHECK((T_1.translation() - goal).norm() < 1e-9);
  CHECK(angle_between(T_0, T_1) < 1e-6);
  // A box lying upright has its z axis up; the tool of a SCARA points down all the same.
  const Eigen::Isometry3d T_box = pose_from_rpy(goal, {0.0, 0.0, 0.7});
  const LinePlan turn =
      plan_line(robot, {.q0 = q0, .T_world_goal = T_box, .task = IkTask::kHeading});
  REQUIRE(turn.ok());
  const Eigen::Isometry3d T_2 = forward(robot, turn.motion.trajectory->end());
  CHECK((T_2.translation() - goal).norm() < 1e-9);
  CHECK(T_2.linear()(2, 2) == doctest::Approx(-1.0));
  CHECK(std::atan2(T_2.linear()(1, 0), T_2.linear()(0, 0)) == doctest::Approx(0.7).epsilon(1e-8));
}

TEST_CASE("an end out of reach is said at once, with the distance") {
  const Robot robot = *make_robot("scara");
  const LinePlan plan = plan_line(robot, {.q0 = Eigen::Vector4d(0.4, 1.0, 0.1, 0.2),
                                          .T_world_goal = make_translation({0.9, 0.0, 0.3}),
                                          .task = IkTask::kPositionFirst});
  REQUIRE(plan.fault.has_value());
  CHECK(plan.fault->kind == LineFaultKind::kGoal);
  CHECK(plan.fault->ik.status == IkStatus::kUnreachable);
  CHECK(plan.fault->ik.diagnosis.distance == doctest::Approx(0.2).epsilon(1e-3));
}

TEST_CASE("a line through the zone the arm cannot fold into names how far it gets") {
  const Robot robot = *make_robot("scara");
  // From (0.5, -0.05) to (-0.5, -0.05), 50 mm beside the axis of joint 1; the arm folds to 257 mm.
  const Eigen::Vector3d a(0.5, -0.05, 0.3);
  const Eigen::Vector3d b(-0.5, -0.05, 0.3);
  const IkResult start =
      solve_ik(robot, make_translation(a), {.seed = {}, .task = IkTask::kPosition});
  REQUIRE(start.ok());
  const LinePlan plan = plan_line(
      robot, {.q0 = start.q, .T_world_goal = make_translation(b), .task = IkTask::kPosition});
  REQUIRE(plan.fault.has_value());
  CHECK(plan.fault->kind == LineFaultKind::kPath);
  // 0.16 + 0.09 + 2 * 0.12 cos(140 deg) is the square of the smallest radius.
  const double smallest = std::sqrt(0.25 + 0.24 * std::cos(140.0 * M_PI / 180.0));
  const double x = std::sqrt(smallest * smallest - 0.05 * 0.05);
  CHECK(plan.fault->fraction == doctest::Approx(0.5 - x).epsilon(2e-3));
}

TEST_CASE("too short a time names the joint; a tool speed is only an upper bound") {
  const Robot robot = *make_robot("scara");
  const Eigen::Vector4d q0(0.4, 1.0, 0.1, 0.2);
  Eigen::Isometry3d T_goal = forward(robot, q0);
  T_goal.translation().z() -= 0.05;
  LineMove move{.q0 = q0, .T_world_goal = T_goal};
  move.time = 0.01;
  const LinePlan fast = plan_line(robot, move);
  CHECK_FALSE(fast.ok());
  REQUIRE(fast.motion.too_fast.has_value());
  CHECK(fast.motion.too_fast->joint == 2);
  CHECK(fast.motion.too_fast->travel == doctest::Approx(0.05));
  move.time = fast.motion.too_fast->least_time;
  CHECK(plan_line(robot, move).ok());
  move.time.reset();
  move.tool_speed = 0.1;
  CHECK(plan_line(robot, move).motion.trajectory->duration() ==
        doctest::Approx(1.875 * 0.05 / 0.1).epsilon(1e-9));
  move.tool_speed = 100.0;
  CHECK(plan_line(robot, move).motion.trajectory->duration() ==
        doctest::Approx(fast.motion.too_fast->least_time).epsilon(1e-9));
  move.tool_speed.reset();
  move.time = 0.0;
  move.enforce_limits = false;
  const LinePlan none = plan_line(robot, move);
  CHECK_FALSE(none.ok());
  CHECK(none.motion.too_fast.has_value());
}

TEST_CASE("a line of no length stands still for its time") {
  const Robot robot = *make_robot("scara");
  const Eigen::Vector4d q0(0.4, 1.0, 0.1, 0.2);
  LineMove move{.q0 = q0, .T_world_goal = forward(robot, q0)};
  CHECK(plan_line(robot, move).motion.trajectory->duration() == 0.0);
  move.time = 2.0;
  const LinePlan plan = plan_line(robot, move);
  REQUIRE(plan.ok());
  CHECK(plan.motion.trajectory->duration() == 2.0);
  CHECK(plan.motion.trajectory->end() == q0);
}

TEST_CASE("broken poses, times and speeds are refused") {
  const Robot robot = *make_robot("scara");
  LineMove good{.q0 = Eigen::Vector4d(0.4, 1.0, 0.1, 0.2)};
  const auto refused = [&](auto change) {
    LineMove move = good;
    change(move);
    CHECK_THROWS_AS((void)plan_line(robot, move), ArgumentError);
  };
  refused([](LineMove& m) { m.q0.resize(3); });
  refused([](LineMove& m) { m.q0[1] = std::nan(""); });
  refused([](LineMove& m) { m.T_world_goal.translation()[0] = INFINITY; });
  refused([](LineMove& m) { m.T_world_goal.linear() *= 2.0; });
  refused([](LineMove& m) { m.time = -1.0; });
  refused([](LineMove& m) { m.time = std::nan(""); });
  refused([](LineMove& m) { m.tool_speed = 0.0; });
  refused([](LineMove& m) { m.time = 1.0, m.tool_speed = 1.0; });
}

// The quintic law over a length s has its highest speed 1.875 s / T and its highest acceleration
// 10 / sqrt(3) s / T^2 (Biagiotti and Melchiorri, Trajectory Planning (2008), table 3.2).
TEST_CASE("a line takes as long as the limits of the tool and the asked fraction say") {
  const Robot robot = *make_robot("scara");
  LineMove move{.q0 = Eigen::Vector4d(0.4, 1.0, 0.1, 0.2)};
  move.T_world_goal = forward(robot, move.q0);
  move.T_world_goal.translation().y() -= 0.1;
  const double fastest = plan_line(robot, move).motion.trajectory->duration();
  move.speed = 0.25;
  CHECK(plan_line(robot, move).motion.trajectory->duration() ==
        doctest::Approx(4.0 * fastest).epsilon(1e-9));
  move.speed = 1.0;
  move.tool_accel = 0.01;
  CHECK(plan_line(robot, move).motion.trajectory->duration() ==
        doctest::Approx(std::sqrt(10.0 / std::sqrt(3.0) * 0.1 / 0.01)).epsilon(1e-9));
  move.tool_speed = 0.001;
  CHECK(plan_line(robot, move).motion.trajectory->duration() ==
        doctest::Approx(1.875 * 0.1 / 0.001).epsilon(1e-9));
  move.tool_accel = -1.0;
  CHECK_THROWS_AS((void)plan_line(robot, move), ArgumentError);
}
