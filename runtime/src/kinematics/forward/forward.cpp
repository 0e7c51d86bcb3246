#include "armlet/kinematics/forward.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "kernels.hpp"

namespace armlet {

Eigen::Isometry3d forward(const Robot& robot, JointsIn q) {
  check_size("q", q.size(), robot.n());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    return forward(coupling->rows, coupling->values(q));
  Eigen::Isometry3d T_world_tool;
  kernel_for(kPoseKernels, robot.n())(robot.walk_plan(), q.data(), T_world_tool.data());
  return T_world_tool;
}

Eigen::Isometry3d link_frame(const Robot& robot, JointsIn q, int k) {
  check_size("q", q.size(), robot.n());
  if (k < 0 || k > robot.rows()) {
    throw ArgumentError(fmt::format(
        "There is no frame {} in robot `{}`; expected 0 for the base or 1 to {} for a joint.", k,
        robot.name(), robot.rows()));
  }
  if (k == 0) return robot.T_world_base();
  std::vector<Eigen::Isometry3d> frames = link_frames(robot, q);
  return frames[static_cast<std::size_t>(k - 1)];
}

std::vector<Eigen::Isometry3d> link_frames(const Robot& robot, JointsIn q) {
  std::vector<Eigen::Isometry3d> frames(static_cast<std::size_t>(robot.rows()));
  link_frames(robot, q, frames);
  return frames;
}

Eigen::Isometry3d link_frames(const Robot& robot, JointsIn q, std::span<Eigen::Isometry3d> frames) {
  check_size("q", q.size(), robot.n());
  check_size("frames", static_cast<Eigen::Index>(frames.size()), robot.rows());
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]]
    return link_frames(coupling->rows, coupling->values(q), frames);
  Eigen::Isometry3d T_world_tool;
  kernel_for(kFramesKernels, robot.n())(robot.walk_plan(), q.data(), frames.data()->data(),
                                        T_world_tool.data());
  return T_world_tool;
}

}  // namespace armlet
