// The tool of an arm that is dragged by a pointer: it follows, keeps its orientation and does not
// jump.
#include "armlet/kinematics/dragged_tool.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/limits.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/kinematics/reach.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"
#include "sanitized.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// The SCARA of the laboratory that `armlet lab --demo` opens, with the end of its gripper.
Robot demo_scara() {
  RobotSpec spec;
  const auto revolute = [](double d, double a, double alpha, double limit) {
    Joint joint;
    joint.dh.d = d;
    joint.dh.a = a;
    joint.dh.alpha = alpha;
    joint.lower = -limit;
    joint.upper = limit;
    return joint;
  };
  spec.joints.push_back(revolute(0.4, 0.25, 0.0, 170.0 * kPi / 180.0));
  spec.joints.push_back(revolute(0.0, 0.15, kPi, 145.0 * kPi / 180.0));
  Joint slide;
  slide.kind = JointKind::kPrismatic;
  slide.lower = 0.0;
  slide.upper = 0.15;
  spec.joints.push_back(slide);
  spec.joints.push_back(revolute(0.0, 0.0, 0.0, 2.0 * kPi));
  spec.T_flange_tool = make_translation({0.0, 0.0, 0.25});
  return Robot(spec);
}

double largest_step(const VectorXd& q_1, const VectorXd& q_2) {
  return (q_1 - q_2).cwiseAbs().maxCoeff();
}

// A closed path of a pointer from a pose outwards and back, always with the same orientation.
struct PointerPath {
  Isometry3d T_start;
  Vector3d out, aside;
  double width = 0.0;

  PointerPath(const Robot& robot, const VectorXd& q, Random& random) : T_start(forward(robot, q)) {
    const auto direction = [&random] {
      const Vector3d v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      return v.norm() > 0.1 ? Vector3d(v.normalized()) : Vector3d(1, 0, 0);
    };
    out = direction();
    aside = direction();
    width = random.uniform(0.2, 1.5) * robot.reach();
  }
  Isometry3d at(double share) const {
    Isometry3d T = T_start;
    T.translation() +=
        width * std::sin(kPi * share) * out + 0.3 * width * std::sin(2.0 * kPi * share) * aside;
    return T;
  }
};

}  // namespace

TEST_CASE("a SCARA that is pulled out of its reach keeps the direction of its gripper") {
  const Robot robot = demo_scara();
  VectorXd q = Eigen::Vector4d(0.3, -0.6, 0.05, 0.2), q_before = q;
  const Isometry3d T_start = forward(robot, q);
  double by_search = 0.0;  // what joint 4 does if every goal is solved by itself
  for (int k = 1; k <= 8; ++k) {
    CAPTURE(k);
    Isometry3d T = T_start;
    T.translation() += k * Vector3d(0.03, 0.012, 0.0);
    const IkResult searched =
        solve_ik(robot, T, {.seed = q_before, .task = IkTask::kPositionFirst});
    const VectorXd& q_searched = searched.ok() ? searched.q : searched.diagnosis.q_nearest;
    by_search = std::max(by_search, std::abs(q_searched[3] - q_before[3]));
    q_before = q_searched;

    const DraggedTool dragged = drag_tool(robot, T, q);
    CHECK(dragged.angle < 1e-6);
    CHECK(largest_step(dragged.q, q) < 0.8);
    CHECK(dragged.q[1] < 1e-3);                  // the elbow stays on its side
    if (T.translation().head<2>().norm() > 0.4)  // the nearest point of the circle of 400 mm
      CHECK(dragged.distance ==
            doctest::Approx(T.translation().head<2>().norm() - 0.4).epsilon(1e-5));
    q = dragged.q;
  }
  CHECK(by_search > 1.0);
  CHECK(drag_tool(robot, T_start, q).has_pose());
}

TEST_CASE("of arms with a wrist no joint turns over while the tool is pulled outwards") {
  for (const char* name : {"puma560", "irb120", "ur5", "kr6"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    VectorXd q = clamp_to_limits(robot, robot.home() + VectorXd::LinSpaced(robot.n(), 0.3, -0.5));
    const Isometry3d T_start = forward(robot, q);
    const Vector3d out = (T_start.translation() - robot.T_world_base().translation()).normalized();
    for (int k = 1; k <= 100; ++k) {
      Isometry3d T = T_start;
      T.translation() += 0.01 * k * robot.reach() * out;
      const DraggedTool dragged = drag_tool(robot, T, q);
      CHECK(largest_step(dragged.q, q) < 0.8);
      CHECK(within_limits(robot, dragged.q));
      q = dragged.q;
    }
  }
}

TEST_CASE("along a path of a pointer the joints change by a bounded amount") {
  constexpr int kDrags = kSanitized ? 1 : 12;  // of each arm: 204 of all
  constexpr int kEvents = 150;
  Random random(45);
  int arms = 0, drags = 0, events = 0, jumps = 0;
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    const double length = robot.length();
    ++arms;
    for (int drag = 0; drag < kDrags; ++drag, ++drags) {
      VectorXd q = random_joints(robot, random);
      const PointerPath path(robot, q, random);
      bool was_there = true;
      for (int k = 1; k <= kEvents; ++k, ++events) {
        CAPTURE(name);
        CAPTURE(drag);
        CAPTURE(k);
        const Isometry3d T = pose_to_keep(robot, path.at(1.0 * k / kEvents), q);
        const Isometry3d T_before = path.at((k - 1.0) / kEvents);
        const double moved = (T.translation() - T_before.translation()).norm() / length;
        const double far = (forward(robot, q).translation() - T.translation()).norm();
        const DraggedTool now = drag_tool(robot, T, q);
        REQUIRE(now.q.allFinite());
        REQUIRE(within_limits(robot, now.q));
        const double change = largest_step(now.q, q);
        if (change > 0.5) ++jumps;
        // Whatever happens, a large change brings the tool nearer.
        const double nearer = std::max(0.0, far - now.distance) / length;
        CHECK(change < 1.1 + 26.0 * nearer);
        // Where the goal was and is reached, away from singularities, it bounds the change.
        const double sigma =
            std::min(singularity(robot, q).sigma_min, singularity(robot, now.q).sigma_min) / length;
        if (was_there && now.has_pose() && sigma > 0.05) CHECK(change * sigma < 4.0 * moved + 1e-5);
        was_there = now.has_pose();
        q = now.q;
      }
    }
  }
  CHECK(arms >= 16);
  MESSAGE(drags << " drags of " << arms << " arms, " << events << " events, " << jumps
                << " with more than 0.5 rad or m");
  CHECK(jumps * 100 < events);  // a fifth of the events if every goal is solved by itself
}

TEST_CASE("a goal within reach is reached as solve_ik reaches it, and a single one at once") {
  Random random(46);
  int reached = 0, count = 0;
  for (const std::string_view name : {"scara", "puma560", "ur5", "panda", "kr6", "stanford"}) {
    const Robot robot = *make_robot(name);
    for (int k = 0; k < (kSanitized ? 4 : 40); ++k, ++count) {
      CAPTURE(name);
      CAPTURE(k);
      const VectorXd q_goal = random_joints(robot, random);
      const Isometry3d T = forward(robot, q_goal);
      const VectorXd q = clamp_to_limits(robot, q_goal + VectorXd::NullaryExpr(robot.n(), [&] {
                                                  return random.uniform(-.2, .2);
                                                }));
      const DraggedTool dragged = drag_tool(robot, T, q, {.gradually = false});
      if (!dragged.has_pose()) {
        CHECK(explain(robot, T, dragged).size() > 30);
        continue;
      }
      ++reached;
      CHECK((forward(robot, dragged.q).translation() - T.translation()).norm() <= 1e-6);
      CHECK(angle_between(forward(robot, dragged.q), T) <= 1e-6);
      CHECK(explain(robot, T, dragged).empty());
      CHECK(largest_step(drag_tool(robot, T, dragged.q).q, dragged.q) < 1e-5);
    }
  }
  CHECK(reached * 10 > count * 9);
}

TEST_CASE("the reason names the joint that stops the tool, or the distance") {
  const Robot robot = demo_scara();
  const VectorXd q = Eigen::Vector4d(0.0, 0.5, 0.05, 0.0);
  Isometry3d low = forward(robot, q);
  low.translation().z() = -0.5;
  const DraggedTool below = drag_tool(robot, low, q);
  CHECK(below.at_limit == std::vector<int>{2});
  CHECK(explain(robot, low, below).find("joint 3 is at its limit of 150 mm") != std::string::npos);
  Isometry3d far = forward(robot, q);
  far.translation().x() = 1.0;
  far.translation().y() = 0.0;
  const DraggedTool beyond = drag_tool(robot, far, q);
  CHECK(beyond.at_limit.empty());
  CHECK(explain(robot, far, beyond).find("is out of reach by 600 mm") != std::string::npos);
}

TEST_CASE("wrong goals and joint values of a dragged tool are refused") {
  const Robot robot = demo_scara();
  Isometry3d T = forward(robot, robot.home());
  CHECK_THROWS_AS(drag_tool(robot, T, VectorXd::Zero(3)), ArgumentError);
  VectorXd q = robot.home();
  q[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(drag_tool(robot, T, q), ArgumentError);
  T.translation().x() = 1e9;
  CHECK_THROWS_AS(drag_tool(robot, T, robot.home()), ArgumentError);
  T = forward(robot, robot.home());
  T.linear() *= 2.0;
  CHECK_THROWS_AS(drag_tool(robot, T, robot.home()), ArgumentError);
}

TEST_CASE("the box of an arm's reach contains all of its positions and touches some") {
  Random random(47);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const ReachBox& box = reach_box(robot);
    for (int k = 0; k < (kSanitized ? 200 : 4000); ++k) {
      const Vector3d p = forward(robot, random_joints(robot, random)).translation();
      REQUIRE((p.array() >= box.lower.array() - 1e-9).all());
      REQUIRE((p.array() <= box.upper.array() + 1e-9).all());
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto height = [&](JointsIn q) { return forward(robot, q).translation()[axis]; };
      const double found = height(maximise_over_joints(robot, height, kSanitized ? 2 : 8));
      CHECK(box.upper[axis] >= found - 1e-6);
      CHECK(box.upper[axis] <= found + 1e-3 * robot.reach());
    }
  }
  const ReachBox& box = reach_box(demo_scara());
  CHECK(box.upper.x() == doctest::Approx(0.4));
  CHECK(box.lower.y() == doctest::Approx(-0.4));
  CHECK(box.lower.z() == doctest::Approx(0.0).epsilon(1e-9));
  CHECK(box.upper.z() == doctest::Approx(0.15));
}
