#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"

namespace armlet {

// One branch of the closed form at a goal, each revolute joint at the copy nearest to the seed.
//
// outside  joints whose values in this branch exceed their limits, and those values.
// change   the largest joint change from the seed, rad or m; `joint` is the joint with it, from 0.
struct BranchReport {
  std::string name;
  Eigen::VectorXd q;
  std::vector<LimitViolation> outside;
  double change = 0.0;
  int joint = 0;
};

// How inverse kinematics found its answer: the solver, every branch with the reason that excludes
// it, and the result.
struct IkReport {
  ClosedFormKind kind = ClosedFormKind::kNone;
  bool reversed = false;
  int held_joint = -1;
  std::optional<Posture> posture;      // the requested posture
  std::vector<BranchReport> branches;  // nearest to the seed first
  IkResult result;
};

// Solves like solve_ik and keeps the details. Goal and options as there; a wrong goal or seed is no
// exception here either.
IkReport report_ik(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                   const IkOptions& options = {});

// Several lines: the solver and the reason for it, a line for each branch (> marks the chosen one),
// the remaining errors, or the reason why there is no solution and the nearest reachable pose.
// T_world_tool is the goal of the report.
std::string to_text(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                    const IkReport& report);

}  // namespace armlet
