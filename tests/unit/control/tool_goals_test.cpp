#include "armlet/control/tool_goals.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

VectorXd random_joints(Random& random, const Robot& robot) {
  VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] =
        robot.lower()[i] + (0.2 + 0.6 * random.uniform()) * (robot.upper()[i] - robot.lower()[i]);
  return q;
}

}  // namespace

TEST_CASE("forward kinematics of a solved goal is its pose") {
  Random random(0x273);
  for (const char* name : {"scara", "puma560", "ur5"}) {
    const auto robot = make_robot(name);
    for (int k = 0; k < 40; ++k) {
      const Eigen::Isometry3d T = forward(*robot, random_joints(random, *robot));
      const SolvedGoal goal = solve_goal(*robot, {T}, robot->home());
      INFO(name, " ", k);
      REQUIRE(goal.ok());
      const Eigen::Isometry3d reached = forward(*robot, goal.q);
      CHECK((reached.translation() - T.translation()).norm() < 1e-6);  // tolerance of solve_ik
      CHECK((reached.linear() - T.linear()).norm() < 1e-5);
    }
  }
}

TEST_CASE("a position without orientation keeps the orientation of the goal before") {
  Random random(0x274);
  const auto robot = make_robot("puma560");
  int kept = 0;
  int out_of_reach = 0;
  for (int k = 0; k < 40; ++k) {
    SolvedGoal before;
    before.q = random_joints(random, *robot);
    before.T_world_tool = forward(*robot, before.q);
    const Eigen::Isometry3d T = Eigen::Translation3d(0.01, -0.01, 0.01) * before.T_world_tool;
    const SolvedGoal goal =
        goal_after(*robot,
                   {.T_world_tool = Eigen::Isometry3d(Eigen::Translation3d(T.translation())),
                    .has_orientation = false},
                   before);
    if (!goal.ok()) {
      ++out_of_reach;
      continue;
    }
    CHECK((goal.T_world_tool.translation() - T.translation()).norm() < 1e-6);
    if ((goal.T_world_tool.linear() - before.T_world_tool.linear()).norm() < 1e-9) ++kept;
  }
  CHECK(out_of_reach <= 4);
  CHECK(kept >= 34);  // the others are at the edge of the reach with this orientation
}

TEST_CASE("a pose that tilts the tool of an arm which cannot tilt it is refused") {
  const auto robot = make_robot("scara");
  Eigen::Isometry3d T = forward(*robot, robot->home());
  CHECK(task_of(*robot, {T}));
  T.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  CHECK_FALSE(task_of(*robot, {T}));
  CHECK(task_of(*robot, {T, false}) == IkTask::kPositionFirst);
  const SolvedGoal goal = solve_goal(*robot, {T}, robot->home());
  REQUIRE(goal.refusal);
  CHECK(std::holds_alternative<refused::Tilted>(*goal.refusal));
}

TEST_CASE("joint values beyond the limits are a goal only where limits are reported") {
  const auto robot = make_robot("scara");
  VectorXd q = robot->home();
  q[0] = robot->upper()[0] + 0.2;
  q[1] = 0.5;
  const Robot free = with_wider_limits(*robot, q);
  const ToolPose pose{forward(free, q)};
  const SolvedGoal refused = solve_goal(*robot, pose, q);
  CHECK_FALSE(refused.ok());
  const SolvedGoal goal = solve_goal(*robot, pose, q, LimitCheck::kWarn);
  REQUIRE(goal.ok());
  CHECK((forward(free, goal.q).translation() - pose.T_world_tool.translation()).norm() < 1e-6);
}

TEST_CASE("wider limits contain the old ones and the given values") {
  const auto robot = make_robot("puma560");
  const VectorXd far = robot->upper().array() + 100.0;
  for (const VectorXd& q : {VectorXd(), far}) {
    const Robot wider = with_wider_limits(*robot, q);
    CHECK((wider.lower().array() < robot->lower().array()).all());
    CHECK((wider.upper().array() > robot->upper().array()).all());
    CHECK(wider.home() == robot->home());
    if (q.size() > 0) CHECK(within_limits(wider, q));
  }
}

}  // namespace armlet
