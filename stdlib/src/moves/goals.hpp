#pragma once
// The whole pose of a target, for functions that need it before the path is planned.

#include "moves/moves.hpp"

namespace armlet::bind {

// A pose, and joint values that reach it.
struct Goal {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  Eigen::VectorXd q{};
};

// The pose of a target in the world when the arm comes from another goal: a target without
// orientation keeps the orientation as far as the arm can.
Answer<Goal> goal_after(Vm& vm, const MoveCall& call, const PosC& target, const Goal& before);

}  // namespace armlet::bind
