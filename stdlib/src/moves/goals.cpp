#include "moves/goals.hpp"

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"

namespace armlet::bind {
namespace {

constexpr double kGoalTolerance = 1e-10;  // m and rad, tried before the solver's default tolerance

// Solves with the smallest error possible.
Answer<Eigen::VectorXd> solve_exactly(Vm& vm, const MoveCall& call, const PosC& target,
                                      const Eigen::VectorXd& seed) {
  const Robot& robot = model_of(vm, call);
  if (const std::optional<IkTask> task = task_of(robot, target)) {
    IkOptions options{.seed = seed, .task = *task, .diagnose = false};
    options.position_tolerance = kGoalTolerance;
    options.rotation_tolerance = kGoalTolerance;
    IkResult exact = solve_ik(robot, target.T, options);
    if (exact.ok()) return std::move(exact.q);
  }
  return solve_target(vm, call, target, seed);
}

}  // namespace

Answer<Goal> goal_after(Vm& vm, const MoveCall& call, const PosC& target, const Goal& before) {
  const Robot& robot = model_of(vm, call);
  if (!target.has_orientation) {
    const Eigen::Isometry3d kept = make_pose(before.T_world_tool.linear(), target.T.translation());
    IkResult same = solve_ik(robot, kept, {.seed = before.q, .diagnose = false});
    if (same.ok()) return Goal{kept, std::move(same.q)};
  }
  auto q = solve_exactly(vm, call, target, before.q);
  if (!q) return Failed{};
  const bool is_whole = task_of(robot, target) == IkTask::kPose;
  return Goal{is_whole ? target.T : forward(robot, *q), std::move(*q)};
}

}  // namespace armlet::bind
