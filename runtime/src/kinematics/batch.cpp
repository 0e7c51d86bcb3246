#include "armlet/kinematics/batch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"
#include "batch_plan.hpp"
#include "kernels.hpp"
#include "math/det_quick_lanes.hpp"

namespace armlet {

bool is_supported(InstructionSet set) {
#if defined(__x86_64__)
  switch (set) {
    case InstructionSet::kBaseline:
      return true;
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2");
    default:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  }
#else
  return set == InstructionSet::kBaseline;
#endif
}

InstructionSet best_instruction_set() {
  static const InstructionSet best = is_supported(InstructionSet::kAvx512) ? InstructionSet::kAvx512
                                     : is_supported(InstructionSet::kAvx2)
                                         ? InstructionSet::kAvx2
                                         : InstructionSet::kBaseline;
  return best;
}

namespace {

const char* name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::kBaseline:
      return "baseline";
    case InstructionSet::kAvx2:
      return "AVX2";
    default:
      return "AVX-512";
  }
}

// Fewer configurations than lanes are a matter for a narrower set: the bits are the same.
const BatchKernels& kernels_for(InstructionSet set, std::size_t count) {
  if (set == InstructionSet::kAvx512 && count >= kAvx512Batch.lanes) return kAvx512Batch;
  if (set >= InstructionSet::kAvx2 && count >= kAvx2Batch.lanes) return kAvx2Batch;
  return kBaselineBatch;
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
  if (!is_supported(set)) {
    throw ArgumentError(
        fmt::format("This machine has no {}; expected a set up to {}, which best_instruction_set() "
                    "returns.",
                    name_of(set), name_of(best_instruction_set())));
  }
  const std::size_t n = static_cast<std::size_t>(robot.n());
  const std::size_t count = q.size() / n;
  if (count * n != q.size()) {
    throw ArgumentError(
        fmt::format("`q` has {} elements; expected a multiple of the {} joints.", q.size(), n));
  }
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

// One configuration after the other: what is refused does not depend on the width either.
[[gnu::cold]] void careful_batch_turns(const BatchArm& arm, const double* q, std::size_t count,
                                       const BlockTurns& block) {
  for (std::size_t lane = 0; lane < block.lanes; ++lane) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      const std::size_t k = block.k + lane;
      const double value = q[i * count + k];
      if (!std::isfinite(value)) {
        throw ArgumentError(fmt::format(
            "The value of joint {} in configuration {} is {}; expected a finite number.", i + 1,
            k + 1, value));
      }
      const double angle = arm.theta[i] + value * arm.turn[i];
      if (!det::is_too_large(angle)) continue;
      const det::SinCos turn = det::sincos(angle);
      block.sines[i * block.stride + lane] = turn.sin;
      block.cosines[i * block.stride + lane] = turn.cos;
    }
  }
}

}  // namespace armlet
