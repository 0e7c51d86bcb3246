#include "armlet/kinematics/batch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"
#include "batch_flags.hpp"
#include "kernels.hpp"

namespace armlet {
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
const BatchKernels* kernels_for(InstructionSet set, std::size_t count) {
  for (const auto& [kernels, needed] : {std::pair(&kAvx512Batch, InstructionSet::kAvx512),
                                        std::pair(&kAvx2Batch, InstructionSet::kAvx2)}) {
    if (needed <= set && kernels->lanes <= count) return kernels;
  }
  return &kBaselineBatch;
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
  if (q.size() % n != 0) {
    throw ArgumentError(
        fmt::format("`q` has {} elements; expected a multiple of the {} joints.", q.size(), n));
  }
  const std::size_t count = q.size() / n;
  check_size(out_name, static_cast<Eigen::Index>(out.size()),
             static_cast<Eigen::Index>(entries * count));
  return count;
}

}  // namespace

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
  for (const InstructionSet set : {InstructionSet::kAvx512, InstructionSet::kAvx2}) {
    if (is_supported(set)) return set;
  }
  return InstructionSet::kBaseline;
}

void forward_batch(const Robot& robot, std::span<const double> q, std::span<double> poses,
                   InstructionSet set) {
  const std::size_t count = checked_count(robot, q, 12, poses, "poses", set);
  if (count == 0) return;
  const WalkPlan& plan = robot.walk_plan();
  if (count == 1) {
    std::array<double, 16> T{};
    kernel_for(kPoseKernels, plan.n)(plan, q.data(), T.data());
    for (std::size_t e = 0; e < 12; ++e) poses[e] = T[4 * (e / 3) + e % 3];
    return;
  }
  const BatchFlags flags(plan);
  kernels_for(set, count)->poses(batch_arm(plan, flags), q.data(), count, poses.data());
}

void jacobian_batch(const Robot& robot, std::span<const double> q, std::span<double> jacobians,
                    InstructionSet set) {
  const std::size_t entries = 6 * static_cast<std::size_t>(robot.n());
  const std::size_t count = checked_count(robot, q, entries, jacobians, "jacobians", set);
  if (count == 0) return;
  const WalkPlan& plan = robot.walk_plan();
  if (count == 1) {
    kernel_for(kJacobianKernels, plan.n)(plan, q.data(), jacobians.data());
    return;
  }
  const BatchFlags flags(plan);
  kernels_for(set, count)->jacobians(batch_arm(plan, flags), q.data(), count, jacobians.data());
}

[[gnu::cold]] void careful_batch_turns(const BatchArm& arm, const double* q, std::size_t count,
                                       std::size_t k, std::size_t lanes, double* sine,
                                       double* cosine) {
  for (std::size_t i = 0; i < arm.n; ++i) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double value = q[i * count + k + lane];
      if (!std::isfinite(value)) {
        throw ArgumentError(fmt::format(
            "The value of joint {} in configuration {} is {}; expected a finite number.", i + 1,
            k + lane + 1, value));
      }
      const det::SinCos turn = det::sincos(arm.theta[i] + value * arm.turn[i]);
      sine[i * lanes + lane] = turn.sin;
      cosine[i * lanes + lane] = turn.cos;
    }
  }
}

}  // namespace armlet
