#include "armlet/kinematics/batch.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "batch_table.hpp"
#include "chain/batch_lines.hpp"
#include "chain/batch_plan.hpp"
#include "kinematics/forward/kernels.hpp"

namespace armlet {

namespace {

const BatchKernels& kernels_for(InstructionSet set, std::size_t count) {
  return kernels_for(set, count, kAvx512Batch, kAvx2Batch, kBaselineBatch);
}

// Whether the batch is one configuration whose sizes are right.
bool is_single(const Robot& robot, std::span<const double> q, std::size_t entries,
               std::span<double> out, InstructionSet set) {
  return q.size() == static_cast<std::size_t>(robot.n()) && out.size() == entries &&
         set <= best_instruction_set();
}

// The number of configurations; checks all arguments.
std::size_t checked_count(const Robot& robot, std::span<const double> q, std::size_t entries,
                          std::span<double> out, std::string_view out_name, InstructionSet set) {
  check_supported(set);
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const std::size_t count = count_configurations(q, n);
  check_size(out_name, static_cast<Eigen::Index>(out.size()),
             static_cast<Eigen::Index>(entries * count));
  return count;
}

// The values of the rows of a coupled arm, one configuration in each column.
BatchLines columns_of_rows(const JointCoupling& coupling, std::span<const double> q,
                           std::size_t count) {
  const Eigen::Map<const BatchLines> joints(q.data(), coupling.E.cols(),
                                            static_cast<Eigen::Index>(count));
  BatchLines rows = coupling.E * joints;
  return rows.colwise() + coupling.offset;
}

// Adds up the columns of rows that the same joint moves.
void coupled_jacobians(const Robot& robot, std::span<const double> q, std::span<double> jacobians,
                       InstructionSet set) {
  const JointCoupling& coupling = *robot.coupling();
  const auto n = static_cast<std::size_t>(robot.n());
  const std::size_t count = checked_count(robot, q, 6 * n, jacobians, "jacobians", set);
  const auto columns = static_cast<Eigen::Index>(count);
  BatchLines of_rows(6 * robot.rows(), columns);
  jacobian_batch(coupling.rows, numbers_of(columns_of_rows(coupling, q, count)),
                 {of_rows.data(), static_cast<std::size_t>(of_rows.size())}, set);
  Eigen::Map<BatchLines> out(jacobians.data(), 6 * robot.n(), columns);
  out.setZero();
  for (int k = 0; k < robot.rows(); ++k) {
    const auto [joint, ratio] = motion_of_row(robot, k);
    out.middleRows<6>(6 * joint) += ratio * of_rows.middleRows<6>(6 * k);
  }
}

}  // namespace

void forward_batch(const Robot& robot, std::span<const double> q, std::span<double> poses,
                   InstructionSet set) {
  if (const JointCoupling* coupling = robot.coupling()) [[unlikely]] {
    const std::size_t count = checked_count(robot, q, 12, poses, "poses", set);
    return forward_batch(coupling->rows, numbers_of(columns_of_rows(*coupling, q, count)), poses,
                         set);
  }
  const WalkPlan& plan = robot.walk_plan();
  if (is_single(robot, q, 12, poses, set))
    return kernel_for(kQuickPoseKernels, plan.n)(plan, q.data(), poses.data());
  const std::size_t count = checked_count(robot, q, 12, poses, "poses", set);
  if (count > 0) kernels_for(set, count).poses(batch_arm(plan), q.data(), count, poses.data());
}

void jacobian_batch(const Robot& robot, std::span<const double> q, std::span<double> jacobians,
                    InstructionSet set) {
  if (robot.coupling() != nullptr) [[unlikely]]
    return coupled_jacobians(robot, q, jacobians, set);
  const WalkPlan& plan = robot.walk_plan();
  const std::size_t entries = 6 * static_cast<std::size_t>(robot.n());
  if (is_single(robot, q, entries, jacobians, set))
    return kernel_for(kQuickJacobianKernels, plan.n)(plan, q.data(), jacobians.data());
  const std::size_t count = checked_count(robot, q, entries, jacobians, "jacobians", set);
  if (count > 0)
    kernels_for(set, count).jacobians(batch_arm(plan), q.data(), count, jacobians.data());
}

}  // namespace armlet
