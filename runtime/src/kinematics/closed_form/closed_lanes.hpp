#pragma once

#include <memory>

#include "armlet/kinematics/batch.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "canonical_rows.hpp"
#include "chain/batch_plan.hpp"
#include "closed_arm.hpp"

namespace armlet {

ClosedKernel* closed_kernel_for(InstructionSet set);

// An arm of six revolute joints prepared for the kernels of the closed forms.
class LaneForm {
 public:
  // nullptr if the family has no kernel.
  static std::unique_ptr<LaneForm> make(ClosedFormKind kind, const CanonicalRows& rows,
                                        const Chain& chain);

  // All solutions for a pose. False if the functions with branches are needed (ClosedKernel).
  bool solve(const Eigen::Isometry3d& T_world_tool, ClosedLanes& out) const {
    return solve(T_world_tool, out, *closed_kernel_for(best_instruction_set()));
  }
  // The same on a given instruction set, with the same bits.
  bool solve(const Eigen::Isometry3d& T_world_tool, ClosedLanes& out, ClosedKernel& kernel) const;

 private:
  LaneForm(LaneFamily family, const CanonicalRows& rows, const Chain& chain);
  void prepare_links();

  CanonicalRows rows_;
  WalkPlan plan_;
  ClosedArm arm_{};
};

}  // namespace armlet
