#include "armlet/collision/motion_check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd random_joints(const Robot& robot, Random& random) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    q[i] = random.uniform(std::max(robot.lower()[i], -3.0), std::min(robot.upper()[i], 3.0));
  }
  return q;
}

Trajectory move_between(const Robot& robot, const VectorXd& q0, const VectorXd& q1,
                        const std::string& planner) {
  const MotionPlan plan =
      plan_joint_move(PlannerSet(), robot, {.q0 = q0, .q1 = q1, .planner = planner, .speed = 1.0});
  REQUIRE(plan.ok());
  return *plan.trajectory;
}

ArmInMotion in_motion(const Robot& robot, const Trajectory& motion) {
  return {.robot = &robot, .motion = &motion, .solids = robot.derived<ArmSolids>().solids()};
}

// All of the arm that moves against one fixed body.
MotionScene against(const Robot& robot, const Trajectory& motion, const Solid& wall) {
  MotionScene scene{.arms = {in_motion(robot, motion)}, .fixed = {wall}};
  scene.duration = motion.duration();
  for (int i = 0; i < static_cast<int>(scene.arms[0].solids.size()); ++i) {
    if (scene.arms[0].solids[static_cast<std::size_t>(i)].frame > 0)
      scene.pairs.push_back({.a = {0, i}, .b = {BodyRef::kFixed, 0}});
  }
  return scene;
}

Solid wall_at(const Vector3d& p, const Vector3d& axis, double angle, const Vector3d& size) {
  Solid wall = solid_of(Shape(Box{size}));
  wall.T.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  wall.T.translation() = p;
  return wall;
}

// A body of a scene at time t, placed without the code under test.
Solid placed(const MotionScene& scene, const BodyRef& ref, double t) {
  if (ref.arm == BodyRef::kFixed) return scene.fixed[static_cast<std::size_t>(ref.index)];
  const ArmInMotion& arm = scene.arms[static_cast<std::size_t>(ref.arm)];
  VectorXd q(arm.robot->n());
  for (int i = 0; i < arm.robot->n(); ++i) q[i] = arm.motion->value(i, arm.from + t);
  const ArmSolid& own = arm.solids[static_cast<std::size_t>(ref.index)];
  Solid solid = own.solid;
  solid.T = link_frame(*arm.robot, q, own.frame) * own.solid.T;
  return solid;
}

double distance_at(const MotionScene& scene, const CheckedPair& pair, double t) {
  return gap_between(placed(scene, pair.a, t), placed(scene, pair.b, t)).distance;
}

// The first of `samples` instants at which a pair overlaps by more than `depth`; infinite if none.
double first_sampled(const MotionScene& scene, int samples, double depth) {
  for (int k = 0; k <= samples; ++k) {
    const double t = scene.duration * k / samples;
    for (const CheckedPair& pair : scene.pairs) {
      const Solid a = placed(scene, pair.a, t), b = placed(scene, pair.b, t);
      if ((a.T.translation() - b.T.translation()).norm() > a.reach() + b.reach()) continue;
      if (gap_between(a, b).distance < -depth) return t;
    }
  }
  return std::numeric_limits<double>::infinity();
}

TEST_CASE("a wall of 1 mm is never passed: 10,000 moves against dense sampling") {
  Random random(11);
  const std::shared_ptr<const Robot> arms[] = {make_robot("planar3"), make_robot("scara"),
                                               make_robot("puma560")};
  const char* const planners[] = {"Syn", "SCurve", "Fastest"};
  int met = 0, tunnelled = 0, free = 0;
  for (int round = 0; round < 10'000; ++round) {
    const Robot& robot = *arms[round % 10 == 0 ? 2 : round % 2];
    const Trajectory motion = move_between(robot, random_joints(robot, random),
                                           random_joints(robot, random), planners[round % 3]);
    const double reach = robot.reach();
    // Near the path of the tool point.
    const double share = random.uniform();
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = motion.value(i, share * motion.duration());
    const Vector3d at = forward(robot, q).translation() + 0.15 * reach *
                                                              Vector3d(random.uniform(-1.0, 1.0),
                                                                       random.uniform(-1.0, 1.0),
                                                                       random.uniform(-1.0, 1.0));
    const Vector3d axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.1);
    const Solid wall = wall_at(at, axis, random.uniform(0.0, 3.0),
                               {random.uniform(0.02, 0.2), random.uniform(0.02, 0.2), 0.001});
    const MotionScene scene = against(robot, motion, wall);
    const MotionCheck check = check_motion(scene);
    REQUIRE(check.resolution < 1.1e-4);
    const double dense = first_sampled(scene, 100, kSoft + check.resolution);
    if (check.meetings.empty()) {
      ++free;
      REQUIRE(dense > motion.duration());
      continue;
    }
    ++met;
    if (first_sampled(scene, 10, kSoft) > motion.duration()) ++tunnelled;
    REQUIRE(check.meetings.front().t <= dense);
    for (const Meeting& each : check.meetings) {
      REQUIRE(distance_at(scene, scene.pairs[each.pair], each.t) < -kSoft);
      REQUIRE(each.depth >= kSoft);
    }
  }
  MESSAGE("met " << met << ", of these missed by ten samples " << tunnelled << ", free " << free);
  CHECK(met > 1000);
  CHECK(tunnelled > 50);
  CHECK(free > 1000);
}

// Two arms of one joint, 0.4 m long, that rotate into each other like the pointers of clocks.
TEST_CASE("two arms that move at once are checked over time") {
  const std::shared_ptr<const Robot> model = make_robot("planar2");
  const Robot left = *model;
  const Robot right =
      model->with_base(Isometry3d(Eigen::Translation3d(2.2 * model->reach(), 0.0, 0.0)));
  const auto line = [](double first, double second, double duration) {
    const auto path = [&](double from, double to) {
      JointPath joint{.q_end = to};
      if (duration > 0.0) {
        joint.segments.push_back({.duration = duration, .degree = 1});
        joint.segments[0].c[0] = from;
        joint.segments[0].c[1] = (to - from) / duration;
      }
      return joint;
    };
    return Trajectory({path(first, second), path(0.0, 0.0)}, duration);
  };
  const double pi = std::numbers::pi;
  const auto check = [&](const Robot& second_arm, const Trajectory& a, const Trajectory& b,
                         double from) {
    MotionScene scene{.arms = {in_motion(left, a), in_motion(second_arm, b)}};
    scene.arms[1].from = from;
    scene.duration = a.duration();
    for (int i = 0; i < static_cast<int>(scene.arms[0].solids.size()); ++i) {
      for (int k = 0; k < static_cast<int>(scene.arms[1].solids.size()); ++k)
        scene.pairs.push_back({.a = {0, i}, .b = {1, k}});
    }
    return check_motion(scene);
  };
  // Too far apart even stretched towards each other.
  CHECK(check(right, line(1.0, 0.0, 1.0), line(pi, pi - 1.0, 1.0), 0.0).meetings.empty());
  const Robot near = model->with_base(Isometry3d(Eigen::Translation3d(1.6 * model->reach(), 0, 0)));
  // One arrives where the other one is, or has just left, or will come.
  CHECK_FALSE(check(near, line(1.0, 0.0, 1.0), line(pi, pi, 1.0), 0.0).meetings.empty());
  CHECK(check(near, line(1.0, 0.0, 1.0), line(pi, pi + 1.5, 1.0), 0.0).meetings.empty());
  CHECK_FALSE(check(near, line(1.0, 0.0, 1.0), line(pi + 1.5, pi, 1.0), 0.0).meetings.empty());
  // The same motion of the other one, begun earlier: it has gone, or has arrived and stays.
  CHECK(check(near, line(1.0, 0.0, 1.0), line(pi, pi + 1.5, 2.0), 1.0).meetings.empty());
  CHECK_FALSE(check(near, line(1.0, 0.0, 1.0), line(pi + 1.5, pi, 2.0), 9.0).meetings.empty());
}

// The tool of a SCARA goes down by `way`, with a body of 40 mm in its gripper that stands on a
// table.
MotionCheck slide_down(double way, double gap, bool leaving) {
  const std::shared_ptr<const Robot> robot = make_robot("scara");
  VectorXd q0 = robot->home();
  q0[2] = 0.06;
  VectorXd q1 = q0;
  q1[2] += way;
  const Trajectory motion = move_between(*robot, q0, q1, "Syn");
  MotionScene scene{.arms = {in_motion(*robot, motion)}};
  scene.duration = motion.duration();
  Solid cube = solid_of(Shape(Box{{0.04, 0.04, 0.04}}));
  cube.T = robot->T_flange_tool();
  const Isometry3d T_world_tool = forward(*robot, q0);
  scene.arms[0].solids = {{.frame = robot->n(), .solid = cube}};
  Solid table = solid_of(Shape(Box{{1.0, 1.0, 0.1}}));
  table.T.translation() = T_world_tool.translation() - Vector3d(0.0, 0.0, 0.07 + gap);
  scene.fixed = {table};
  scene.pairs = {{.a = {0, 0}, .b = {BodyRef::kFixed, 0}, .leaving = leaving}};
  return check_motion(scene);
}

TEST_CASE("depth, time and the height that would do, worked out by hand") {
  // The joint of this SCARA points down.
  const MotionCheck check = slide_down(0.05, 0.02, false);
  REQUIRE(check.meetings.size() == 1);
  const Meeting& met = check.meetings[0];
  CHECK(met.depth == doctest::Approx(0.03).epsilon(1e-4));
  CHECK(met.higher == doctest::Approx(0.03).epsilon(0.01));
  CHECK(met.t > 0.0);
  CHECK(met.t < met.t_deepest);
  CHECK(slide_down(0.02, 0.02, false).meetings.empty());
  CHECK(slide_down(0.0200005, 0.02, false).meetings.empty());
  CHECK(slide_down(0.0203, 0.02, false).meetings.size() == 1);
}

TEST_CASE("the height that would do clears the whole motion, and a millimetre less does not") {
  Random random(23);
  const std::shared_ptr<const Robot> arms[] = {make_robot("scara"), make_robot("puma560"),
                                               make_robot("ur5")};
  int looked = 0;
  for (int round = 0; round < 400; ++round) {
    const Robot& robot = *arms[round % 3];
    const Trajectory motion =
        move_between(robot, random_joints(robot, random), random_joints(robot, random), "Syn");
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = motion.value(i, 0.5 * motion.duration());
    const Solid block = wall_at(forward(robot, q).translation(), {0.3, 0.2, 1.0},
                                random.uniform(0.0, 3.0), {0.02, 0.05, random.uniform(0.01, 0.1)});
    MotionScene scene = against(robot, motion, block);
    for (const Meeting& each : check_motion(scene).meetings) {
      if (each.higher < 0.0) continue;
      ++looked;
      MotionScene alone = scene;
      alone.pairs = {scene.pairs[each.pair]};
      alone.fixed[0].T.translation().z() -= each.higher;
      CHECK(first_sampled(alone, 1000, kSoft + 5e-5) > motion.duration());
      alone.fixed[0].T.translation().z() += 0.001;
      CHECK(first_sampled(alone, 4000, 0.0) <= motion.duration());
    }
  }
  CHECK(looked > 100);
}

TEST_CASE("what stands on a table leaves it, and is seen when it goes into it") {
  CHECK(slide_down(-0.03, 0.0, true).meetings.empty());
  CHECK(slide_down(-0.03, -0.001, true).meetings.empty());
  CHECK(slide_down(-0.03, -0.001, false).meetings.size() == 1);
  CHECK(slide_down(0.03, 0.0, true).meetings.size() == 1);
}

TEST_CASE("what starts deeper than a touch is seen from the start on, also when it leaves") {
  for (const double depth : {0.011, 0.02, 0.035}) {
    CAPTURE(depth);
    const MotionCheck check = slide_down(-0.06, -depth, true);
    REQUIRE(check.meetings.size() == 1);
    CHECK(check.meetings[0].t == 0.0);
    CHECK(check.meetings[0].depth == doctest::Approx(depth).epsilon(1e-4));
  }
  CHECK(slide_down(-0.06, -0.009, true).meetings.empty());
}

// Thin walls that links pass: few samples fall into the deepest part of the passage.
TEST_CASE("depths are not below those of dense sampling, and are reached: random moves") {
  Random random(12);
  const std::shared_ptr<const Robot> arms[] = {make_robot("scara"), make_robot("puma560"),
                                               make_robot("ur5")};
  int looked = 0;
  for (int round = 0; round < 250; ++round) {
    const Robot& robot = *arms[round % 3];
    const Trajectory motion =
        move_between(robot, random_joints(robot, random), random_joints(robot, random), "SCurve");
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = motion.value(i, 0.5 * motion.duration());
    const Vector3d axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.3);
    const Solid wall = wall_at(forward(robot, q).translation(), axis, random.uniform(0.0, 3.0),
                               {random.uniform(0.003, 0.01), 0.2, random.uniform(0.05, 0.2)});
    const MotionScene scene = against(robot, motion, wall);
    for (const Meeting& each : check_motion(scene).meetings) {
      ++looked;
      double deepest = 0.0;
      constexpr int kSamples = 3000;
      for (int k = 0; k <= kSamples; ++k) {
        const double t = each.t + (scene.duration - each.t) * k / kSamples;
        deepest = std::max(deepest, -distance_at(scene, scene.pairs[each.pair], t));
      }
      CHECK(each.depth > deepest - 2e-5);
      const double reached = -distance_at(scene, scene.pairs[each.pair], each.t_deepest);
      // Depths of convex bodies are measured to 5e-8 m, and the joints of the search are rounded
      // otherwise than those of the motion.
      CHECK(reached <= each.depth + 1e-7);
      CHECK(reached > each.depth - 1e-3);
      CHECK_FALSE(each.at_least);
    }
  }
  CHECK(looked > 100);
}

TEST_CASE("sliding along a face for long is touching, and does not take long") {
  const std::shared_ptr<const Robot> robot = make_robot("scara");
  VectorXd q0 = robot->home(), q1 = q0;
  q0[0] = -1.5;
  q1[0] = 1.5;
  const Trajectory motion = move_between(*robot, q0, q1, "Syn");
  MotionScene scene{.arms = {in_motion(*robot, motion)}};
  scene.duration = motion.duration();
  Solid cube = solid_of(Shape(Box{{0.04, 0.04, 0.04}}));
  cube.T = robot->T_flange_tool();
  scene.arms[0].solids = {{.frame = robot->n(), .solid = cube}};
  Solid table = solid_of(Shape(Box{{3.0, 3.0, 0.1}}));
  table.T.translation().z() = forward(*robot, q0).translation().z() - 0.07;
  scene.fixed = {table};
  scene.pairs = {{.a = {0, 0}, .b = {BodyRef::kFixed, 0}}};
  const MotionCheck check = check_motion(scene);
  CHECK(check.meetings.empty());
  CHECK(check.looks < 200'000);
  MESSAGE("looks: " << check.looks);
}

TEST_CASE("a scene that cannot be is refused") {
  const std::shared_ptr<const Robot> robot = make_robot("scara");
  const Trajectory three = Trajectory::at_rest(VectorXd::Zero(3), 1.0);
  CHECK_THROWS_AS(check_motion({.arms = {in_motion(*robot, three)}, .duration = 1.0}),
                  ArgumentError);
  const Trajectory four = Trajectory::at_rest(VectorXd::Zero(4), 1.0);
  MotionScene scene{.arms = {in_motion(*robot, four)}, .duration = 1.0};
  scene.pairs = {{.a = {0, 0}, .b = {BodyRef::kFixed, 0}}};
  CHECK_THROWS_AS(check_motion(scene), ArgumentError);
  scene.pairs = {{.a = {0, 99}, .b = {0, 0}}};
  CHECK_THROWS_AS(check_motion(scene), ArgumentError);
}

// A pair that is not reported keeps its clearance in dense samples; one that is reported comes
// nearer than 5 % more, but for what happens between samples.
TEST_CASE("clearances are certain for the whole motion, and what keeps 5 % more is not reported") {
  constexpr int kSamples = 600;
  Random random(31);
  int near = 0, clear = 0, unseen = 0;
  for (const char* name : {"puma560", "ur5", "scara"}) {
    const auto robot = make_robot(name);
    for (int round = 0; round < 60; ++round) {
      const VectorXd q0 = random_joints(*robot, random), q1 = random_joints(*robot, random);
      const Trajectory motion = move_between(*robot, q0, q1, round % 2 == 0 ? "Syn" : "Spline5");
      const Vector3d beside(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.1);
      const MotionScene scene = against(
          *robot, motion,
          wall_at(forward(*robot, 0.5 * (q0 + q1)).translation() + beside, Vector3d(1.0, 2.0, 0.5),
                  random.uniform(0.0, 3.0), Vector3d(0.01, 0.2, 0.3)));
      const double clearance = random.uniform(0.001, 0.05);
      const std::vector<double> keep(scene.pairs.size(), clearance);
      const std::vector<Nearing> found = check_clearances(scene, keep);
      for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        double least = 1e9;
        for (int k = 0; k <= kSamples; ++k)
          least =
              std::min(least, distance_at(scene, scene.pairs[i], scene.duration * k / kSamples));
        const auto it = std::ranges::find(found, i, &Nearing::pair);
        if (it == found.end()) {
          ++clear;
          REQUIRE(least >= clearance - 1e-9);
          continue;
        }
        ++near;
        CHECK(distance_at(scene, scene.pairs[i], it->t) < 1.05 * clearance + 1e-9);
        if (least > 1.05 * clearance) ++unseen;
      }
    }
  }
  CHECK(near > 100);
  CHECK(clear > 100);
  CHECK(unseen <= 2);
}

TEST_CASE("clearances are one for each pair") {
  const auto robot = make_robot("scara");
  const Trajectory still = Trajectory::at_rest(robot->home(), 1.0);
  const MotionScene scene =
      against(*robot, still,
              wall_at(Vector3d(5.0, 0.0, 0.0), Vector3d::UnitZ(), 0.0, Vector3d(0.1, 0.1, 0.1)));
  CHECK(check_clearances(scene, std::vector<double>(scene.pairs.size(), 0.01)).empty());
  CHECK_THROWS_AS(check_clearances(scene, std::vector<double>(scene.pairs.size() + 1, 0.01)),
                  ArgumentError);
}

}  // namespace
}  // namespace armlet
