#include <fmt/format.h>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/dragged_tool.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/format_vector.hpp"

namespace armlet {
namespace {

// "joint 2 is at its limit of 145 deg"; empty if no joint is at a limit.
std::string stops(const Robot& robot, const DraggedTool& dragged) {
  std::string text;
  for (const int i : dragged.at_limit) {
    text += fmt::format("{}joint {} is at its limit of {}", text.empty() ? "" : " and ", i + 1,
                        format_joint_value(robot.joint(i).kind, dragged.q[i]));
  }
  return text;
}

// Only an arm with a closed form answers this while a pointer moves.
bool has_other_solution(const Robot& robot, const Eigen::Isometry3d& T_world_goal,
                        const DraggedTool& dragged) {
  if (robot.n() > 6 || !closed_form(robot).exists()) return false;
  IkOptions options;
  options.seed = dragged.q;
  options.task = robot.n() < 6 ? IkTask::kPosition : IkTask::kPose;
  options.starts = 1;
  options.diagnose = false;
  return solve_ik(robot, T_world_goal, options).ok();
}

}  // namespace

std::string explain(const Robot& robot, const Eigen::Isometry3d& T_world_goal,
                    const DraggedTool& dragged) {
  if (dragged.has_pose()) return {};
  const std::string limits = stops(robot, dragged);
  std::string text;
  if (dragged.has_position()) {
    text = fmt::format("The point is reached, but the orientation differs by {}",
                       format_deg(dragged.angle));
    if (!limits.empty()) text += ": " + limits;
  } else if (limits.empty()) {
    text = fmt::format("The point {} is out of reach by {}; the tool comes as near as {}",
                       format_point_mm(T_world_goal.translation()), format_mm(dragged.distance),
                       format_point_mm(dragged.T_world_tool.translation()));
  } else {
    text = fmt::format("The tool stops {} from the point {}: {}", format_mm(dragged.distance),
                       format_point_mm(T_world_goal.translation()), limits);
  }
  if (has_other_solution(robot, T_world_goal, dragged))
    text += ". Other joint values of the arm reach it, but not without a detour";
  return text + ".";
}

}  // namespace armlet
