#include "collision/table_axes.hpp"

namespace armlet {
namespace {

constexpr double kSameAxis = 1e-9;

// From the axis of joint k to that of joint k + 1, counted from 1, without the joint's own motion
// along and about the former.
Eigen::Isometry3d T_axis_next(const Robot& robot, int k) {
  return T_frame_link(robot, k).inverse() * T_frame_axis(robot, k);
}

bool are_parallel(const Eigen::Isometry3d& T_axis_next) {
  return T_axis_next.linear().col(2).head<2>().norm() < kSameAxis;
}

// Whether joints k and k + 1 have the same axis.
bool is_one_axis(const Robot& robot, int k) {
  const Eigen::Isometry3d T = T_axis_next(robot, k);
  return are_parallel(T) && T.translation().head<2>().norm() < kSameAxis;
}

}  // namespace

Eigen::Isometry3d T_frame_link(const Robot& robot, int link) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  if (!standard || link == 0 || link > robot.n()) return Eigen::Isometry3d::Identity();
  return dh_pose(DhConvention::kStandard, robot.joint(link - 1).dh).inverse();
}

Eigen::Isometry3d T_frame_axis(const Robot& robot, int k) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  if (standard || k >= robot.n()) return Eigen::Isometry3d::Identity();
  return dh_pose(DhConvention::kModified, robot.joint(k).dh);
}

bool may_be_side_by_side(const Robot& robot, int lower, int upper) {
  for (int k = lower + 1; k < upper; ++k) {
    if (!are_parallel(T_axis_next(robot, k))) return false;
  }
  return true;
}

int first_on_axis(const Robot& robot, int k) {
  while (k > 1 && is_one_axis(robot, k - 1)) --k;
  return k;
}

}  // namespace armlet
