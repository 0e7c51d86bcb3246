#include "controls/hand.hpp"

#include <algorithm>
#include <numbers>

#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/ik.hpp"
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
  const Isometry3d T = pose_of(forward(*robot.model, robot.q), axes, values);
  IkOptions options;
  options.seed = robot.q;
  options.task = std::ranges::all_of(axes, is_place)
                     ? IkTask::kPositionFirst
                     : frame_task(*robot.model, T).value_or(IkTask::kPose);
  const IkResult result = solve_ik(*robot.model, T, options);
  if (result.ok()) return result.q;
  const IkDiagnosis& why = result.diagnosis;
  if (unreached != nullptr) {
    unreached->T_world_tool = T;
    unreached->q_nearest = why.q_nearest;
    unreached->T_world_nearest = why.nearest;
    unreached->distance = why.distance;
    unreached->angle = why.angle;
  }
  return Error{"unreachable", explain(*robot.model, T, result)};
}

std::vector<std::array<double, 2>> hand_reach(const CellRobot& robot,
                                              std::span<const HandAxis> axes) {
  const Vector3d p_base = robot.model->T_world_base().translation();
  const double reach = robot.model->reach();
  std::vector<std::array<double, 2>> ranges;
  for (const HandAxis axis : axes) {
    const double middle = is_place(axis) ? p_base[place_of(axis)] : 0.0;
    const double most = is_place(axis)             ? reach
                        : axis == HandAxis::kPitch ? std::numbers::pi / 2
                                                   : std::numbers::pi;
    ranges.push_back({middle - most, middle + most});
  }
  return ranges;
}

}  // namespace armlet
