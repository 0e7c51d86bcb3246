#include "armlet/kinematics/batch.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "batch_table.hpp"
#include "chain/batch_plan.hpp"
#include "kinematics/forward/kernels.hpp"

namespace armlet {

namespace {

const BatchKernels& kernels_for(InstructionSet set, std::size_t count) {
  return kernels_for(set, count, kAvx512Batch, kAvx2Batch, kBaselineBatch);
}

// One configuration, with nothing to complain of.
bool is_single(const Robot& robot, std::span<const double> q, std::size_t entries,
               std::span<double> out, InstructionSet set) {
  return q.size() == static_cast<std::size_t>(robot.n()) && out.size() == entries &&
         set <= best_instruction_set();
}

// The number of configurations, after everything has been checked.
std::size_t checked_count(const Robot& robot, std::span<const double> q, std::size_t entries,
                          std::span<double> out, std::string_view out_name, InstructionSet set) {
  check_supported(set);
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const std::size_t count = count_configurations(q, n);
  check_size(out_name, static_cast<Eigen::Index>(out.size()),
             static_cast<Eigen::Index>(entries * count));
  return count;
}

}  // namespace

void forward_batch(const Robot& robot, std::span<const double> q, std::span<double> poses,
                   InstructionSet set) {
  const WalkPlan& plan = robot.walk_plan();
  if (is_single(robot, q, 12, poses, set))
    return kernel_for(kQuickPoseKernels, plan.n)(plan, q.data(), poses.data());
  const std::size_t count = checked_count(robot, q, 12, poses, "poses", set);
  if (count > 0) kernels_for(set, count).poses(batch_arm(plan), q.data(), count, poses.data());
}

void jacobian_batch(const Robot& robot, std::span<const double> q, std::span<double> jacobians,
                    InstructionSet set) {
  const WalkPlan& plan = robot.walk_plan();
  const std::size_t entries = 6 * static_cast<std::size_t>(robot.n());
  if (is_single(robot, q, entries, jacobians, set))
    return kernel_for(kQuickJacobianKernels, plan.n)(plan, q.data(), jacobians.data());
  const std::size_t count = checked_count(robot, q, entries, jacobians, "jacobians", set);
  if (count > 0)
    kernels_for(set, count).jacobians(batch_arm(plan), q.data(), count, jacobians.data());
}

}  // namespace armlet
