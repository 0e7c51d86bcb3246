// Arms with joints that copy others meet what they meet as arms of as many motors.

#include <doctest/doctest.h>

#include "armlet/collision/motion_check.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/model/robot_scene.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "random_mass.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

Robot arm_of(Random& random) {
  const Mechanism tree = random_coupled_chain(random, 1 + static_cast<int>(random.below(4)),
                                              1 + static_cast<int>(random.below(3)));
  const Result<RobotSpec> read = serial_arm(tree, "tool");
  REQUIRE(read.ok());
  RobotSpec spec = *read;
  for (Link& link : spec.links) {
    link.solids.push_back({.kind = LinkSolidKind::kSphere,
                           .size = {random.uniform(0.02, 0.1), 0.0, 0.0},
                           .T_link_solid = make_translation(random_point(random, 0.2))});
    link.solids.push_back({.kind = LinkSolidKind::kBox,
                           .size = {0.05, 0.1, random.uniform(0.05, 0.3)},
                           .T_link_solid = random_step(random)});
  }
  return Robot(std::move(spec));
}

// The motion of the rows: those that copy a joint go as its path does, times their ratio.
Trajectory motion_of_rows(const Robot& arm, const Trajectory& motion) {
  std::vector<JointPath> paths;
  for (int k = 0; k < arm.rows(); ++k) {
    const auto [joint, ratio] = motion_of_row(arm, k);
    const double offset = arm.coupling()->offset[k];
    JointPath path = motion.joint(joint);
    path.q_end = ratio * path.q_end + offset;
    for (Segment& each : path.segments) {
      for (double& c : each.c) c *= ratio;
      each.c[0] += offset;
    }
    paths.push_back(std::move(path));
  }
  return Trajectory(std::move(paths), motion.duration());
}

MotionScene scene_of(const Robot& arm, const Trajectory& motion, const Solid& wall) {
  MotionScene scene{
      .arms = {{.robot = &arm, .motion = &motion, .solids = arm.derived<ArmSolids>().solids()}},
      .fixed = {wall},
      .duration = motion.duration()};
  const auto count = static_cast<int>(scene.arms[0].solids.size());
  for (int i = 0; i < count; ++i) {
    if (scene.arms[0].solids[static_cast<std::size_t>(i)].frame > 0)
      scene.pairs.push_back({.a = {0, i}, .b = {BodyRef::kFixed, 0}});
  }
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < i; ++k) {
      const int a = scene.arms[0].solids[static_cast<std::size_t>(i)].frame,
                b = scene.arms[0].solids[static_cast<std::size_t>(k)].frame;
      if (a > b + 1) scene.pairs.push_back({.a = {0, i}, .b = {0, k}, .leaving = true});
    }
  }
  return scene;
}

}  // namespace

// Both checks step along the same motion with bounds of their own on how fast a body moves, and end
// a search for a meeting at kTime and kDepth of one another.
constexpr double kTime = 2e-3, kDepth = 2e-4;  // s, m

TEST_CASE("an arm with copying joints meets what its rows meet, at the same times") {
  Random random(9001);
  int met = 0;
  for (int k = 0; k < 300; ++k) {
    const Robot arm = arm_of(random);
    const VectorXd q0 = random_joints(arm, random), q1 = random_joints(arm, random);
    const MotionPlan plan = plan_joint_move(PlannerSet(), arm, {.q0 = q0, .q1 = q1});
    REQUIRE(plan.ok());
    const Trajectory rows = motion_of_rows(arm, *plan.trajectory);
    Solid wall = {.margin = 0.15};
    wall.T = make_translation(random_point(random, 0.8));
    const MotionCheck found = check_motion(scene_of(arm, *plan.trajectory, wall));
    const MotionCheck expected = check_motion(scene_of(arm.uncoupled(), rows, wall));
    REQUIRE(found.meetings.size() == expected.meetings.size());
    met += found.meetings.empty() ? 0 : 1;
    for (std::size_t i = 0; i < found.meetings.size(); ++i) {
      CHECK(found.meetings[i].pair == expected.meetings[i].pair);
      CHECK(std::abs(found.meetings[i].t - expected.meetings[i].t) < kTime);
      CHECK(std::abs(found.meetings[i].depth - expected.meetings[i].depth) < kDepth);
    }
  }
  CHECK(met > 50);
}

TEST_CASE("shapes of an arm with copying joints are those of all its links") {
  Random random(9002);
  for (int k = 0; k < 20; ++k) {
    const Robot arm = arm_of(random);
    CHECK(link_shapes(arm).size() == link_shapes(arm.uncoupled()).size());
    CHECK(arm.derived<ArmSolids>().solids().size() ==
          arm.uncoupled().derived<ArmSolids>().solids().size());
    // A base, all links, the flange and the tool point.
    CHECK(robot_scene(arm).nodes.size() == static_cast<std::size_t>(arm.rows()) + 3);
  }
}
