#pragma once

#include <string>

#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// A move of all joints from rest at q0 to rest at q1; other members as in MoveRequest.
struct JointMove {
  Eigen::VectorXd q0{};
  Eigen::VectorXd q1{};
  std::string planner = "Syn";
  std::optional<double> time{};
  std::optional<double> speed{};
  bool enforce_limits = true;
  const Robot* motors = nullptr;
};

// Plans a move between joint positions and verifies the whole of it.
//
// returns  a plan whose `outside` has the joints whose target is outside their limits, and whose
//          `too_fast` has the joint that needs more time.
// source   B. Siciliano et al., Robotics, 2009, section 4.2 (joint space trajectories).
// throws   ArgumentError for sizes, planners, times and speeds as PlannerSet::plan does.
MotionPlan plan_joint_move(const PlannerSet& planners, const Robot& robot, const JointMove& move);

}  // namespace armlet
