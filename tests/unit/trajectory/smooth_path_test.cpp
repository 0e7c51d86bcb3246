// Accelerations of paths do not jump, wherever joints that have a choice begin and whatever limits
// they come to.
#include <doctest/doctest.h>

#include <random>

#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "motions.hpp"

using namespace armlet;

namespace {

// Two to five positions one behind the other, every other time rotated too, from a position near
// home or anywhere within the limits.
PathMove random_path_of(const Robot& robot, std::mt19937_64& generator) {
  PathMove move{.q0 = joints_near_home(robot, generator, 0.6),
                .task = robot.n() < 6 ? IkTask::kPositionFirst : IkTask::kPose};
  if (generator() % 2 == 0) {
    for (int i = 0; i < robot.n(); ++i)
      move.q0[i] = uniform(generator, robot.lower()[i], robot.upper()[i]);
  }
  const auto places = 2 + generator() % 4;
  const double size = uniform(generator, 0.03, 0.2);
  const bool turns = generator() % 2 == 0;
  Eigen::Isometry3d T = forward(robot, move.q0);
  for (std::size_t k = 0; k < places; ++k) {
    Eigen::Vector3d w = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      T.translation()[i] += uniform(generator, -size, size);
      w[i] = uniform(generator, -0.5, 0.5);
    }
    if (turns) T.rotate(Eigen::AngleAxisd(w.norm(), w.normalized()));
    move.points.push_back({.T_world_tool = T, .blend = uniform(generator, 0.002, 0.04)});
    if (generator() % 3 == 0) move.points.back().tool_speed = uniform(generator, 0.05, 0.5);
  }
  return move;
}

}  // namespace

TEST_CASE("no path of arms with a joint to spare, or of positions alone, falls back to jumps") {
  std::mt19937_64 generator(52);
  for (const char* name : {"pa10", "iiwa14", "panda", "scorbot"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    int made = 0;
    for (int k = 0; k < 40; ++k) {
      CAPTURE(k);
      const PathPlan plan = plan_path(robot, random_path_of(robot, generator));
      if (!plan.ok()) continue;
      ++made;
      check_limits(robot, *plan.motion.trajectory);
    }
    CHECK(made >= 15);
  }
}

// Joints that begin next to a limit stay near it or leave it without a jump.
TEST_CASE("paths that begin next to a limit are run without jumps") {
  const Robot robot = *make_robot("pa10");
  std::mt19937_64 generator(53);
  int along_a_limit = 0;
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    PathMove move = random_path_of(robot, generator);
    const auto joint = static_cast<Eigen::Index>(generator() % 7);
    move.q0[joint] = robot.upper()[joint] - 0.01;
    Eigen::Isometry3d T = forward(robot, move.q0);
    for (PathPoint& point : move.points) {
      for (int i = 0; i < 3; ++i) T.translation()[i] += uniform(generator, -0.1, 0.1);
      point.T_world_tool = T;
    }
    const PathPlan plan = plan_path(robot, move);
    if (!plan.ok()) continue;
    check_limits(robot, *plan.motion.trajectory);
    const auto range = plan.motion.trajectory->range(static_cast<int>(joint));
    along_a_limit += range.upper > robot.upper()[joint] - 0.02 ? 1 : 0;
  }
  CHECK(along_a_limit >= 10);
}
