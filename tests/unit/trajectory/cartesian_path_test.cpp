#include "armlet/trajectory/cartesian_path.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "motions.hpp"
#include "trajectory/tool/pose_curve.hpp"

using namespace armlet;

namespace {

Eigen::Isometry3d shifted(Eigen::Isometry3d T, double x, double y, double z) {
  T.translation() += Eigen::Vector3d(x, y, z);
  return T;
}

const Robot kArm = *make_robot("ur5");
const Eigen::VectorXd kStart = (Eigen::VectorXd(6) << -0.3, -1.3, 1.9, -1.1, -1.5, 0.2).finished();

double corner_distance(const Robot& robot, const Trajectory& motion, const Eigen::Vector3d& p) {
  double least = 1e9;
  for (int k = 0; k <= 4000; ++k) {
    const double t = motion.duration() * k / 4000.0;
    least = std::min(least, (tool_at(robot, motion, t).translation() - p).norm());
  }
  return least;
}

// Highest speed of the tool point between two times, by central differences.
double tool_speed(const Robot& robot, const Trajectory& motion, double t) {
  const double h = 1e-5;
  return (tool_at(robot, motion, t + h).translation() - tool_at(robot, motion, t - h).translation())
             .norm() /
         (2.0 * h);
}

}  // namespace

TEST_CASE("an arc passes its three points in order, all on one circle") {
  std::mt19937_64 generator(1);
  for (int k = 0; k < 1000; ++k) {
    const auto point = [&] {
      return Eigen::Vector3d(uniform(generator, -1.0, 1.0), uniform(generator, -1.0, 1.0),
                             uniform(generator, -1.0, 1.0));
    };
    const Eigen::Vector3d p1 = point(), p2 = point(), p3 = point();
    const auto arc = arc_through(p1, p2, p3);
    REQUIRE(arc);
    const double scale = 1.0 + arc->radius;
    CHECK((arc->at(0.0) - p1).norm() < 1e-12 * scale);
    CHECK((arc->at(1.0) - p3).norm() < 1e-12 * scale * scale);
    CHECK(std::abs((p2 - arc->centre).norm() - arc->radius) < 1e-12 * scale * scale);
    double least = 1e9;
    for (int i = 1; i < 1000; ++i) least = std::min(least, (arc->at(i / 1000.0) - p2).norm());
    CHECK(least <= arc->radius * arc->sweep / 1000.0);
  }
  CHECK_FALSE(arc_through({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  CHECK_FALSE(arc_through({0, 0, 0}, {0, 0, 0}, {2, 2, 2}));
}

// A corner at a right angle run at 1 m/s, rounded for 0.1 s before and after: the distance to the
// corner is 3/16 0.1 sqrt(2), the highest acceleration 0.75 sqrt(2) / 0.1.
TEST_CASE("the rounded corner misses by 0.0265165 and accelerates by 10.6066") {
  CurvePiece a = straight_piece(make_translation({-1, 0, 0}), make_translation({0, 0, 0}));
  CurvePiece b = straight_piece(make_translation({0, 0, 0}), make_translation({0, 1, 0}));
  const CurveCorner corner = cut_corner(a, b, 0.1);
  CHECK(corner.at(0.5).translation().norm() == doctest::Approx(0.0265165).epsilon(1e-6));
  double peak = 0.0;
  const double h = 1e-4;
  for (double u = h; u < 1.0 - h; u += h) {
    const Eigen::Vector3d second = corner.at(u + h).translation() -
                                   2.0 * corner.at(u).translation() +
                                   corner.at(u - h).translation();
    peak = std::max(peak, second.norm() / (h * 0.2 * h * 0.2));
  }
  CHECK(peak == doctest::Approx(10.6066).epsilon(1e-4));
}

TEST_CASE("a rotation along a segment is even, and a corner joins it with continuous rates") {
  const Eigen::Isometry3d T0 = pose_from_rpy({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3});
  const Eigen::Isometry3d T1 = pose_from_rpy({0.5, 0.2, 0.1}, {0.9, -0.2, 0.5});
  const Eigen::Isometry3d T2 = pose_from_rpy({0.5, 0.7, 0.1}, {0.2, 0.4, 1.5});
  const auto arc = arc_through(T1.translation(), {0.6, 0.5, 0.2}, T2.translation());
  CurvePiece a = straight_piece(T0, T1);
  CurvePiece b = arc_piece(T1, T2, *arc);
  const CurveCorner corner = cut_corner(a, b, 0.2 * a.length);
  PoseCurve curve;
  curve.add(a);
  curve.add(corner);
  curve.add(b);
  // Second differences of the pose stay of the order of the step squared: no kink anywhere.
  const double h = 1e-3;
  for (double x = h; x < 1.0 - h; x += h / 3.0) {
    const Vector6d change =
        pose_error(curve.at(x), curve.at(x + h)) - pose_error(curve.at(x - h), curve.at(x));
    CHECK(change.norm() < 40.0 * h * h);
  }
  CHECK((curve.at(0.0).matrix() - T0.matrix()).norm() < 1e-12);
  CHECK((curve.at(1.0).matrix() - T2.matrix()).norm() < 1e-12);
}

// The rule of the language reference, 13.3: 3/16 of blend times |d2 - d1|, whatever the tool does
// besides.
TEST_CASE("a corner misses by its rule, however much the tool rotates along its pieces") {
  std::mt19937_64 generator(12);
  for (int k = 0; k < 300; ++k) {
    const auto random_pose = [&] {
      const auto in = [&](double most) { return uniform(generator, -most, most); };
      const double angle = k % 3 == 0 ? 0.0 : 1.4;
      return pose_from_rpy({in(0.3), in(0.3), in(0.3)}, {in(angle), in(angle), in(angle)});
    };
    const Eigen::Isometry3d T0 = random_pose(), T1 = random_pose(), T2 = random_pose();
    CurvePiece a = straight_piece(T0, T1), b = straight_piece(T1, T2);
    const Eigen::Vector3d way1 = T1.translation() - T0.translation();
    const Eigen::Vector3d way2 = T2.translation() - T1.translation();
    const double blend = uniform(generator, 0.1, 0.5) * std::min(way1.norm(), way2.norm());
    const CurveCorner corner = cut_corner(a, b, blend);
    const Eigen::Vector3d turn = way2.normalized() - way1.normalized();
    CHECK((corner.middle().translation() - T1.translation()).norm() ==
          doctest::Approx(3.0 / 16.0 * blend * turn.norm()).epsilon(1e-9));
    CHECK((corner.at(0.0).translation() - T1.translation()).norm() == doctest::Approx(blend));
    CHECK((corner.at(1.0).translation() - T1.translation()).norm() == doctest::Approx(blend));
    PoseCurve curve;
    curve.add(a);
    curve.add(corner);
    curve.add(b);
    // No kink: at both joints first differences change by no more than the step.
    const double h = 1e-5;
    for (const double s :
         {(a.to - a.from) * a.length, (a.to - a.from) * a.length + corner.length}) {
      const double x = s / curve.length();
      const Vector6d before = pose_error(curve.at(x - h), curve.at(x)) / h;
      const Vector6d behind = pose_error(curve.at(x), curve.at(x + h)) / h;
      CHECK((behind - before).norm() < 1e-2);
    }
  }
}

TEST_CASE("a rotation in place has a corner too") {
  const Eigen::Isometry3d T1 = pose_from_rpy({0.3, 0.0, 0.3}, {0.0, 0.0, 0.0});
  CurvePiece a = straight_piece(pose_from_rpy({0.2, 0.0, 0.3}, {0.0, 0.0, 0.0}), T1);
  CurvePiece b = straight_piece(T1, pose_from_rpy({0.3, 0.0, 0.3}, {0.0, 0.0, 1.0}));
  const CurveCorner corner = cut_corner(a, b, 0.02);
  CHECK((corner.at(0.0).translation() - T1.translation()).norm() == doctest::Approx(0.02));
  CHECK(angle_between(corner.at(1.0), T1) == doctest::Approx(0.1));  // 0.02 m of 0.2 m per radian
}

TEST_CASE("the tool follows the circle, at the samples and between, over the middle point") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  const Eigen::Isometry3d T1 = shifted(T0, 0.0, 0.2, 0.0);
  const Eigen::Vector3d via = shifted(T0, 0.05, 0.1, 0.05).translation();
  const LinePlan plan = plan_arc(kArm, via, {.q0 = kStart, .T_world_goal = T1, .time = 4.0});
  REQUIRE(plan.ok());
  const Trajectory& motion = *plan.motion.trajectory;
  const auto arc = arc_through(T0.translation(), via, T1.translation());
  CHECK(plan.length == doctest::Approx(arc->radius * arc->sweep));
  for (const double knot : motion.knots()) {
    const Eigen::Vector3d p = tool_at(kArm, motion, knot).translation();
    CHECK(std::abs((p - arc->centre).norm() - arc->radius) < 1e-9);
  }
  for (int k = 0; k <= 1000; ++k) {
    const Eigen::Isometry3d T = tool_at(kArm, motion, motion.duration() * k / 1000.0);
    CHECK(std::abs((T.translation() - arc->centre).norm() - arc->radius) < 1e-6);
    CHECK(angle_between(T, T0) < 1e-5);
  }
  CHECK(corner_distance(kArm, motion, via) < 1e-3);
}

TEST_CASE("three positions on one line, and two that are the same, are no arc, with the reason") {
  CHECK(no_circle_over({0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}) == NoCircle::kOnOneLine);
  CHECK(no_circle_over({0, 0, 0}, {0.3, 0, 0}, {0.2, 0, 0}) == NoCircle::kOnOneLine);
  CHECK_FALSE(no_circle_over({0, 0, 0}, {0.1, 1e-6, 0}, {0.2, 0, 0}));
  std::mt19937_64 generator(9);
  for (int k = 0; k < 100; ++k) {
    const auto near = [&](const Eigen::Vector3d& p) {  // within some micrometres
      const auto in = [&] { return uniform(generator, -4e-6, 4e-6); };
      return Eigen::Vector3d(p + Eigen::Vector3d(in(), in(), in()));
    };
    const Eigen::Vector3d p(0.4, 0.1, 0.3), other(0.45, 0.2, 0.25);
    CHECK(no_circle_over(p, other, near(p)) == NoCircle::kStartAndEnd);
    CHECK(no_circle_over(p, near(p), other) == NoCircle::kStartAndVia);
    CHECK(no_circle_over(p, other, near(other)) == NoCircle::kViaAndEnd);
  }
}

TEST_CASE("an arc back to where the tool is, alone and in a path, is refused") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  const Eigen::Vector3d via = shifted(T0, 0.05, 0.0, 0.0).translation();
  const LinePlan alone = plan_arc(kArm, via, {.q0 = kStart, .T_world_goal = T0, .time = 4.0});
  REQUIRE(alone.fault);
  CHECK(alone.fault->kind == LineFaultKind::kNoArc);
  CHECK(alone.fault->no_circle == NoCircle::kStartAndEnd);
  PathMove move{.q0 = kStart};
  move.points = {{.T_world_tool = shifted(T0, 0.0, 0.1, 0.0), .blend = 0.01},
                 {.T_world_tool = shifted(T0, 0.0, 0.1, 0.0), .p_world_via = via}};
  const PathPlan path = plan_path(kArm, move);
  REQUIRE(path.fault);
  CHECK(path.fault->no_circle == NoCircle::kStartAndEnd);
  CHECK(path.point == 1);
}

TEST_CASE("no joint's speed jumps along a path, whatever its corners") {
  std::mt19937_64 generator(8);
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  int made = 0;
  for (int k = 0; k < 60; ++k) {
    PathMove move{.q0 = kStart};
    for (int point = 0; point < 4; ++point) {
      const auto aside = [&] { return uniform(generator, -0.12, 0.12); };
      move.points.push_back({.T_world_tool = shifted(T0, aside(), aside(), aside()),
                             .blend = uniform(generator, 0.002, 0.04)});
    }
    const PathPlan plan = plan_path(kArm, move);
    if (!plan.ok()) continue;
    ++made;
    for (int i = 0; i < 6; ++i) CHECK(plan.motion.trajectory->continuity(i, 1e-8) >= 1);
  }
  CHECK(made >= 40);
}

TEST_CASE("a path rounds its corners by 3/16 r |d2 - d1| and stops where it must not") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart};
  move.points = {{.T_world_tool = shifted(T0, 0.0, 0.15, 0.0), .blend = 0.03},
                 {.T_world_tool = shifted(T0, 0.0, 0.15, 0.1), .blend = 0.0},
                 {.T_world_tool = shifted(T0, 0.1, 0.15, 0.1)}};
  const PathPlan plan = plan_path(kArm, move);
  REQUIRE(plan.ok());
  const Trajectory& motion = *plan.motion.trajectory;
  const double miss = 3.0 / 16.0 * 0.03 * std::sqrt(2.0);
  REQUIRE(plan.missed.size() == 3);
  CHECK(plan.missed[0] == doctest::Approx(miss).epsilon(1e-9));
  CHECK(plan.missed[1] == 0.0);
  CHECK(std::abs(corner_distance(kArm, motion, move.points[0].T_world_tool.translation()) - miss) <
        2e-5);
  CHECK(corner_distance(kArm, motion, move.points[1].T_world_tool.translation()) < 2e-5);
  for (int i = 0; i < 6; ++i) {
    CHECK(motion.continuity(i, 1e-6) >= 1);
    CHECK(motion.peak(i, 1) <= kArm.max_speed()[i] * (1.0 + 1e-9));
    CHECK(motion.peak(i, 2) <= kArm.max_accel()[i] * (1.0 + 1e-9));
  }
  CHECK((forward(kArm, motion.end()).translation() - move.points.back().T_world_tool.translation())
            .norm() < 1e-9);
}

TEST_CASE("tool speeds hold on their pieces, and the time that is asked for is kept") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart};
  move.points = {{.T_world_tool = shifted(T0, 0.0, 0.15, 0.0), .blend = 0.02, .tool_speed = 0.1},
                 {.T_world_tool = shifted(T0, 0.0, 0.15, 0.1), .tool_speed = 0.05}};
  const PathPlan plan = plan_path(kArm, move);
  REQUIRE(plan.ok());
  const Trajectory& motion = *plan.motion.trajectory;
  for (int k = 1; k < 500; ++k) {
    const double t = motion.duration() * k / 500.0;
    const bool second = t > plan.times[0];  // behind the middle of the corner
    // Between the samples the joint splines may be a little quicker than the curve.
    CHECK(tool_speed(kArm, motion, t) <= (second ? 0.05 : 0.1) * 1.005);
  }
  move.time = 10.0;
  CHECK(plan_path(kArm, move).motion.trajectory->duration() == doctest::Approx(10.0));
  move.time = 0.5;
  const PathPlan fast = plan_path(kArm, move);
  CHECK_FALSE(fast.ok());
  REQUIRE(fast.motion.too_fast);
  CHECK(fast.motion.too_fast->least_time == doctest::Approx(motion.duration()));
}

TEST_CASE("a path that cannot be followed names the target") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart};
  move.points = {{.T_world_tool = shifted(T0, 0.0, 0.1, 0.0), .blend = 0.01},
                 {.T_world_tool = shifted(T0, 2.0, 0.1, 0.0)}};
  const PathPlan plan = plan_path(kArm, move);
  CHECK_FALSE(plan.ok());
  REQUIRE(plan.fault);
  CHECK(plan.point == 1);
  move.points.clear();
  CHECK_THROWS_AS((void)plan_path(kArm, move), ArgumentError);
  move.points = {{.T_world_tool = T0, .blend = -0.1}};
  CHECK_THROWS_AS((void)plan_path(kArm, move), ArgumentError);
  move.points = {{.T_world_tool = T0}};
  CHECK(plan_path(kArm, move).motion.trajectory->duration() == 0.0);
}

TEST_CASE("times say when each position is reached or passed by") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart,
                .points = {{.T_world_tool = shifted(T0, 0.1, 0.0, 0.0), .blend = 0.02},
                           {.T_world_tool = shifted(T0, 0.1, 0.0, 0.0)},
                           {.T_world_tool = shifted(T0, 0.1, 0.1, 0.0)},
                           {.T_world_tool = shifted(T0, 0.1, 0.1, 0.05)}}};
  for (const bool timed : {false, true}) {
    if (timed) move.time = 4.0;
    const PathPlan plan = plan_path(kArm, move);
    REQUIRE(plan.ok());
    const Trajectory& motion = *plan.motion.trajectory;
    REQUIRE(plan.times.size() == 4);
    CHECK(plan.times[1] == plan.times[0]);
    CHECK(plan.times[3] == doctest::Approx(motion.duration()).epsilon(1e-9));
    for (std::size_t k = 0; k < 4; ++k) {
      const double apart = (tool_at(kArm, motion, plan.times[k]).translation() -
                            move.points[k].T_world_tool.translation())
                               .norm();
      CHECK(apart == doctest::Approx(plan.missed[k == 1 ? 0 : k]).epsilon(1e-3).scale(0.01));
    }
  }
}

TEST_CASE("the acceleration of the tool is that of its piece") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart,
                .points = {{.T_world_tool = shifted(T0, 0.1, 0.0, 0.0), .tool_accel = 0.1},
                           {.T_world_tool = shifted(T0, 0.0, 0.0, 0.0)}}};
  // Half the distance with 0.1 m/s^2 and half of it back: 2 sqrt(s / a). With limited jerk it takes
  // the time longer that the acceleration takes to be there, some 5 ms, and what the search leaves.
  for (const Jerk jerk : {Jerk::kFree, Jerk::kLimited}) {
    move.jerk = jerk;
    const PathPlan plan = plan_path(kArm, move);
    REQUIRE(plan.ok());
    CHECK(plan.times[0] >= 2.0 * (1.0 - 1e-4));
    CHECK(plan.times[0] <= 2.0 * (jerk == Jerk::kFree ? 1.0 + 1e-3 : 1.0 + 6e-3));
    CHECK(plan.times[1] - plan.times[0] < 1.0);
  }
  move.points[0].tool_accel = 0.0;
  CHECK_THROWS_AS((void)plan_path(kArm, move), ArgumentError);
}

TEST_CASE("tool speeds are kept to the ends, where the joints begin to move") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  const PathMove move{
      .q0 = kStart, .points = {{.T_world_tool = shifted(T0, 0.15, 0.1, 0.05), .tool_speed = 0.1}}};
  const PathPlan plan = plan_path(kArm, move);
  REQUIRE(plan.ok());
  const double T = plan.motion.trajectory->duration();
  for (int k = 1; k < 2000; ++k)
    CHECK(tool_speed(kArm, *plan.motion.trajectory, T * k / 2000.0) < 0.1 * (1.0 + 5e-5));
}

// Between the corners; the joints are those that rotate the tool least, which no formula gives.
TEST_CASE("paths of positions of arms with few joints are found, finely enough to be straight") {
  std::mt19937_64 generator(51);
  int made = 0;
  for (const char* name : {"scara", "scorbot"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 6; ++k) {
      CAPTURE(k);
      Eigen::VectorXd q0 = robot.home();
      for (int i = 0; i < robot.n(); ++i) {
        const double middle = 0.5 * (robot.lower()[i] + robot.upper()[i]);
        q0[i] += 0.3 * (middle - q0[i]) +
                 uniform(generator, -0.2, 0.2) * (robot.is_revolute(i) ? 1.0 : 0.1);
        q0[i] = std::clamp(q0[i], robot.lower()[i], robot.upper()[i]);
      }
      Eigen::Isometry3d T = forward(robot, q0);
      PathMove move{.q0 = q0, .task = IkTask::kPositionFirst};
      for (int point = 0; point < 4; ++point) {
        T = shifted(T, uniform(generator, -0.05, 0.05), uniform(generator, -0.05, 0.05),
                    uniform(generator, -0.05, 0.05));
        move.points.push_back({.T_world_tool = T, .blend = 0.02});
      }
      const PathPlan plan = plan_path(robot, move);
      if (!plan.ok()) continue;
      ++made;
      // Behind the first corner's curve the tool is on the line to the next position.
      const Trajectory& motion = *plan.motion.trajectory;
      const Eigen::Vector3d a = move.points[2].T_world_tool.translation();
      const Eigen::Vector3d b = move.points[3].T_world_tool.translation();
      const Eigen::Vector3d way = (b - a).normalized();
      for (int j = 0; j <= 100; ++j) {
        const Eigen::Vector3d p =
            tool_at(robot, motion, motion.duration() * j / 100.0).translation() - a;
        if (j > 90 && way.dot(p) > 0.021) CHECK((p - way.dot(p) * way).norm() < 1e-6);
      }
    }
  }
  CHECK(made >= 10);
}

namespace {

// The limits as the motion states its peaks, and by differences of its positions and speeds.
void check_limits_and_differences(const Robot& robot, const Trajectory& motion) {
  check_limits(robot, motion);
  const double T = motion.duration();
  const double h = 1e-6 * T;
  for (int i = 0; i < robot.n(); ++i) {
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double t = (T - 2.0 * h) * (k + 0.5) / 200.0 + h;
      const auto rate = [&](int order) {
        return std::abs(motion.value(i, t + h, order) - motion.value(i, t - h, order)) / (2.0 * h);
      };
      speed = std::max(speed, rate(0));
      acceleration = std::max(acceleration, rate(1));
      jerk = std::max(jerk, rate(2));
    }
    CHECK(speed <= robot.max_speed()[i] * (1.0 + 1e-6));
    CHECK(acceleration <= robot.max_accel()[i] * (1.0 + 1e-6));
    CHECK(jerk <= robot.max_jerk()[i] * (1.0 + 1e-4));
  }
}

}  // namespace

TEST_CASE("lines, arcs and paths of many arms keep all limits, and accelerations do not jump") {
  std::mt19937_64 generator(51);
  int lines = 0, arcs = 0, paths = 0;
  for (const char* name : {"scara", "puma560", "ur5", "irb120", "panda", "stanford", "scorbot"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 3; ++k) {
      CAPTURE(k);
      const Eigen::VectorXd q0 = joints_near_home(robot, generator, 0.2);
      const Eigen::Isometry3d T0 = forward(robot, q0);
      const IkTask task = robot.n() < 6 ? IkTask::kPositionFirst : IkTask::kPose;
      const auto aside = [&] { return uniform(generator, -0.08, 0.08); };
      const Eigen::Isometry3d T1 = shifted(T0, aside(), aside(), aside());
      const Eigen::Isometry3d T2 = shifted(T1, aside(), aside(), aside());
      const LinePlan line = plan_line(robot, {.q0 = q0, .T_world_goal = T1, .task = task});
      if (line.ok()) check_limits_and_differences(robot, *line.motion.trajectory);
      const LinePlan arc =
          plan_arc(robot, T1.translation(), {.q0 = q0, .T_world_goal = T2, .task = task});
      if (arc.ok()) check_limits_and_differences(robot, *arc.motion.trajectory);
      const Eigen::Isometry3d T3 = shifted(T2, aside(), aside(), aside());
      const PathPlan path =
          plan_path(robot, {.q0 = q0,
                            .points = {{.T_world_tool = T1, .blend = 0.02},
                                       {.T_world_tool = T2, .blend = 0.01, .tool_speed = 0.1},
                                       {.T_world_tool = T3}},
                            .task = task});
      if (path.ok()) check_limits_and_differences(robot, *path.motion.trajectory);
      paths += path.ok() ? 1 : 0;
      lines += line.ok() ? 1 : 0;
      arcs += arc.ok() ? 1 : 0;
    }
  }
  CHECK(lines >= 12);
  CHECK(arcs >= 8);
  CHECK(paths >= 8);
}

TEST_CASE("without limits on jerk a path is faster, and accelerations jump") {
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  PathMove move{.q0 = kStart,
                .points = {{.T_world_tool = shifted(T0, 0.0, 0.15, 0.0), .blend = 0.03},
                           {.T_world_tool = shifted(T0, 0.0, 0.15, 0.1), .blend = 0.03},
                           {.T_world_tool = shifted(T0, 0.1, 0.15, 0.1)}}};
  const PathPlan smooth = plan_path(kArm, move);
  move.jerk = Jerk::kFree;
  const PathPlan fast = plan_path(kArm, move);
  REQUIRE(smooth.ok());
  REQUIRE(fast.ok());
  CHECK(fast.motion.trajectory->duration() < smooth.motion.trajectory->duration());
  MESSAGE("without limits on jerk " << fast.motion.trajectory->duration() << " s, with them "
                                    << smooth.motion.trajectory->duration() << " s");
  int jumps = 0;
  for (int i = 0; i < 6; ++i) jumps += fast.motion.trajectory->continuity(i, 1e-6) < 2 ? 1 : 0;
  CHECK(jumps > 0);
}

TEST_CASE("the speed of a path is not exceeded, in corners, on arcs and at borders") {
  std::mt19937_64 generator(13);
  const Eigen::Isometry3d T0 = forward(kArm, kStart);
  int made = 0;
  for (int k = 0; k < 6; ++k) {
    CAPTURE(k);
    PathMove move{.q0 = kStart};
    const double speed = uniform(generator, 0.05, 0.2);
    for (int point = 0; point < 4; ++point) {
      const auto aside = [&] { return uniform(generator, -0.1, 0.1); };
      move.points.push_back({.T_world_tool = shifted(T0, aside(), aside(), aside()),
                             .blend = uniform(generator, 0.005, 0.04),
                             .tool_speed = speed});
      if (point == 2)
        move.points.back().p_world_via = shifted(T0, aside(), aside(), aside()).translation();
    }
    for (const Jerk jerk : {Jerk::kLimited, Jerk::kFree}) {
      move.jerk = jerk;
      const PathPlan plan = plan_path(kArm, move);
      if (!plan.ok()) continue;
      ++made;
      const Trajectory& motion = *plan.motion.trajectory;
      double most = 0.0;
      for (int sample = 1; sample < 3000; ++sample)
        most = std::max(most, tool_speed(kArm, motion, motion.duration() * sample / 3000.0));
      CHECK(most <= speed * (1.0 + 1e-5));
      CHECK(most >= 0.98 * speed);
    }
  }
  CHECK(made >= 6);
}
