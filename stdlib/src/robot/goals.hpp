#pragma once
// What pose a target means, where the whole of it has to be known before the way to it.

#include "motion/moves.hpp"

namespace armlet::bind {

// A pose, and joint values that reach it.
struct Goal {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  Eigen::VectorXd q{};
};

// The pose of a target in the world after a pose and joints before it: a position alone keeps the
// orientation as far as the arm can.
Answer<Goal> goal_after(Vm& vm, const MoveCall& call, const PosC& target, const Goal& before);

}  // namespace armlet::bind
