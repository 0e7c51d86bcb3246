// Joint values for poses of the tool, as moves need them.
#pragma once

#include <optional>

#include "armlet/control/refusals.hpp"

namespace armlet {

// The components of a pose that count for this arm. Empty if the arm cannot have its orientation
// for any joint values.
[[nodiscard]] std::optional<IkTask> task_of(const Robot& robot, const ToolPose& pose);

// A pose of the tool in the world and joint values that reach it, or why there are none.
struct SolvedGoal {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  Eigen::VectorXd q{};
  std::optional<Refusal> refusal{};

  [[nodiscard]] bool ok() const { return !refusal.has_value(); }
};

// Joint values for a pose, near `seed`.
//
// limits  with kWarn, joint values outside the limits will do if there are no others.
SolvedGoal solve_goal(const Robot& robot, const ToolPose& pose, const Eigen::VectorXd& seed,
                      LimitCheck limits = LimitCheck::kError);

// The whole pose when the arm comes from another goal: a pose without orientation keeps the
// orientation as far as the arm can. Solved with the smallest error possible.
SolvedGoal goal_after(const Robot& robot, const ToolPose& pose, const SolvedGoal& before,
                      LimitCheck limits = LimitCheck::kError);

// A robot with limits on joint values that contain `q`, if it has n values, and do not restrict
// motions near the old ones.
[[nodiscard]] Robot with_wider_limits(const Robot& robot, const Eigen::VectorXd& q = {});

}  // namespace armlet
