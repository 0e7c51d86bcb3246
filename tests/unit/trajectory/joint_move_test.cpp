#include "armlet/trajectory/joint_move.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

const PlannerSet kPlanners;

}  // namespace

TEST_CASE("a move within the limits ends exactly on its target") {
  const Robot robot = *make_robot("scara");
  const Eigen::Vector4d pick(0.61, 0.94, 0.11, -0.33);
  for (const std::string& name : kPlanners.names()) {
    const MotionPlan plan =
        plan_joint_move(kPlanners, robot,
                        {.q0 = Eigen::VectorXd::Zero(4), .q1 = pick, .planner = name, .time = 4.0});
    REQUIRE(plan.ok());
    CHECK(plan.trajectory->duration() == 4.0);
    CHECK(plan.trajectory->end() == pick);
  }
}

TEST_CASE("a target outside the limits names every joint, before the time is judged") {
  const Robot robot = *make_robot("scara");
  const MotionPlan plan = plan_joint_move(kPlanners, robot,
                                          {.q0 = Eigen::VectorXd::Zero(4),
                                           .q1 = Eigen::Vector4d(0.1, 2.653, -0.02, 0.0),
                                           .time = 1e-3});
  CHECK_FALSE(plan.ok());
  CHECK_FALSE(plan.too_fast.has_value());
  REQUIRE(plan.outside.size() == 2);
  CHECK(plan.outside[0].joint == 1);
  CHECK(plan.outside[0].value == 2.653);
  CHECK(plan.outside[1].joint == 2);
}

TEST_CASE("too short a time is an error, or advice where limits are not enforced") {
  const Robot robot = *make_robot("scara");
  JointMove move{.q0 = Eigen::VectorXd::Zero(4), .q1 = Eigen::Vector4d(1.0, 0.0, 0.0, 0.0)};
  move.time = 0.05;
  const MotionPlan refused = plan_joint_move(kPlanners, robot, move);
  CHECK_FALSE(refused.ok());
  CHECK(refused.too_fast->joint == 0);
  move.enforce_limits = false;
  const MotionPlan advised = plan_joint_move(kPlanners, robot, move);
  CHECK(advised.ok());
  CHECK(advised.too_fast->least_time == refused.too_fast->least_time);
}

TEST_CASE("a planner of the user's own is verified like the others") {
  PlannerSet planners;
  planners.add("Overshoot", [](const MoveRequest& request) {
    std::vector<JointPath> joints;
    for (const double q : request.q1) {
      const Segment hill{.duration = 100.0, .degree = 2, .c = {0.0, 0.5, -0.005}};
      joints.push_back({.segments = {hill}, .q_end = q});
    }
    return Plan{.trajectory = Trajectory(std::move(joints), 100.0)};
  });
  const MotionPlan plan = plan_joint_move(
      planners, *make_robot("scara"),
      {.q0 = Eigen::VectorXd::Zero(4), .q1 = Eigen::VectorXd::Zero(4), .planner = "Overshoot"});
  CHECK_FALSE(plan.ok());
  CHECK(plan.outside.size() == 4);
}

TEST_CASE("sizes and numbers that are not finite are refused") {
  const Robot robot = *make_robot("scara");
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(4);
  Eigen::VectorXd broken = zero;
  broken[2] = std::nan("");
  CHECK_THROWS_AS((void)plan_joint_move(kPlanners, robot, {.q0 = zero, .q1 = broken}),
                  ArgumentError);
  CHECK_THROWS_AS(
      (void)plan_joint_move(kPlanners, robot, {.q0 = zero, .q1 = Eigen::VectorXd::Zero(6)}),
      ArgumentError);
}
