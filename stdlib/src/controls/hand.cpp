#include "controls/hand.hpp"

#include <algorithm>
#include <numbers>

#include "armlet/kinematics/dragged_tool.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/kinematics/reach.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

bool is_place(HandAxis axis) { return axis <= HandAxis::kZ; }
int place_of(HandAxis axis) { return static_cast<int>(axis); }
int angle_of(HandAxis axis) { return static_cast<int>(axis) - static_cast<int>(HandAxis::kRoll); }

// The horizontal direction of the x axis of the tool, or of its y axis if x is vertical.
double heading(const Isometry3d& T) {
  const Eigen::Matrix3d& R = T.linear();
  const bool is_vertical = std::abs(R(2, 0)) > 1.0 - 1e-9;
  const Vector3d axis = is_vertical ? R.col(1) : R.col(0);
  return det::atan2(axis.y(), axis.x());
}

// The present pose of the tool with these coordinates replaced by the values.
Isometry3d pose_of(const Isometry3d& T_now, std::span<const HandAxis> axes,
                   std::span<const double> values) {
  Isometry3d T = T_now;
  Vector3d rpy = rpy_from_R(T_now.linear());
  bool turns = false;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (is_place(axes[i])) {
      T.translation()[place_of(axes[i])] = values[i];
    } else if (axes[i] == HandAxis::kTurn) {
      T.linear() = R_from_rpy({0.0, 0.0, values[i] - heading(T_now)}) * T_now.linear();
    } else {
      rpy[angle_of(axes[i])] = values[i];
      turns = true;
    }
  }
  if (turns) T.linear() = R_from_rpy(rpy);
  return T;
}

}  // namespace

std::vector<double> hand_now(const CellRobot& robot, std::span<const HandAxis> axes) {
  const Isometry3d T = forward(*robot.model, robot.q);
  const Vector3d rpy = rpy_from_R(T.linear());
  std::vector<double> values;
  for (const HandAxis axis : axes) {
    values.push_back(is_place(axis)            ? T.translation()[place_of(axis)]
                     : axis == HandAxis::kTurn ? heading(T)
                                               : rpy[angle_of(axis)]);
  }
  return values;
}

Result<Eigen::VectorXd> hand_joints(const CellRobot& robot, std::span<const HandAxis> axes,
                                    std::span<const double> values, UnreachedGoal* unreached) {
  const Robot& arm = *robot.model;
  const Isometry3d T = pose_of(forward(arm, robot.q), axes, values);
  const bool keeps_orientation = std::ranges::all_of(axes, is_place);
  const IkTask task = frame_task(arm, T).value_or(IkTask::kPose);
  Isometry3d T_goal = T;
  if (keeps_orientation) T_goal = pose_to_keep(arm, T, robot.q);
  if (task == IkTask::kHeading) T_goal = with_heading_of(arm, T, robot.q);
  // The arm follows the sliders. Where it cannot, another solution may be far from the present one.
  const DraggedTool dragged = drag_tool(arm, T_goal, robot.q, {.gradually = false});
  const bool suffices = keeps_orientation && arm.n() < 6;
  if (suffices ? dragged.has_position() : dragged.has_pose()) return dragged.q;
  IkOptions options;
  options.seed = robot.q;
  options.task = keeps_orientation ? IkTask::kPositionFirst : task;
  options.diagnose = false;
  const IkResult result = solve_ik(arm, T, options);
  if (result.ok()) return result.q;
  if (unreached != nullptr) {
    unreached->T_world_tool = T;
    unreached->q_nearest = dragged.q;
    unreached->T_world_nearest = dragged.T_world_tool;
    unreached->distance = dragged.distance;
    unreached->angle = dragged.angle;
  }
  return Error{"unreachable", explain(arm, T_goal, dragged)};
}

namespace {

// The range of headings of an arm that rotates its tool only about the vertical; all headings for
// other arms, and if its joints together rotate by a revolution.
std::array<double, 2> heading_range(const CellRobot& robot) {
  constexpr double kHalf = std::numbers::pi;
  const Robot& arm = *robot.model;
  if (!fixed_tilt(arm) || arm.coupling() != nullptr) return {-kHalf, kHalf};
  const Jacobian J = jacobian(arm, robot.q);
  std::array<double, 2> range = {heading(forward(arm, robot.q)), heading(forward(arm, robot.q))};
  for (int i = 0; i < arm.n(); ++i) {
    const double sense = J(5, i);
    const double down = arm.lower()[i] - robot.q[i], up = arm.upper()[i] - robot.q[i];
    range[0] += std::min(sense * down, sense * up);
    range[1] += std::max(sense * down, sense * up);
  }
  if (!(range[1] - range[0] < 2.0 * kHalf)) return {-kHalf, kHalf};
  return range;
}

}  // namespace

std::vector<std::array<double, 2>> hand_reach(const CellRobot& robot,
                                              std::span<const HandAxis> axes) {
  constexpr double kHalf = std::numbers::pi;
  const ReachBox& box = reach_box(*robot.model);
  std::vector<std::array<double, 2>> ranges;
  for (const HandAxis axis : axes) {
    const int place = place_of(axis);
    if (is_place(axis)) {
      ranges.push_back({box.lower[place], box.upper[place]});
    } else if (axis == HandAxis::kTurn) {
      ranges.push_back(heading_range(robot));
    } else {
      const double most = axis == HandAxis::kPitch ? kHalf / 2 : kHalf;
      ranges.push_back({-most, most});
    }
  }
  return ranges;
}

}  // namespace armlet
