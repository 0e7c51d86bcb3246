#pragma once

#include <optional>
#include <string>
#include <vector>

#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"

namespace armlet {

// One branch of the closed form at a goal, each revolute joint at the copy nearest to the seed.
//
// outside  the joints that rule it out, with what they would have to be.
// change   the largest joint change from the seed, rad or m, and `joint`, whose it is, from 0.
struct BranchReport {
  std::string name;
  Eigen::VectorXd q;
  std::vector<LimitViolation> outside;
  double change = 0.0;
  int joint = 0;
};

// How a question of inverse kinematics was answered: the solver, every branch with what rules it
// out, and the result.
struct IkReport {
  ClosedFormKind kind = ClosedFormKind::kNone;
  bool reversed = false;
  int held_joint = -1;
  std::optional<Posture> posture;      // that was asked for
  std::vector<BranchReport> branches;  // nearest to the seed first
  IkResult result;
};

// Answers as solve_ik does and keeps how: the goal and the options as there, never throws for what
// the goal or the seed is.
IkReport report_ik(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                   const IkOptions& options = {});

// Several lines: the solver and why, a line for each branch (the one taken marked with >), the
// errors that are left, or the reason why there is no solution and the nearest pose that there is.
// T_world_tool is the goal that the report is about.
std::string to_text(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                    const IkReport& report);

}  // namespace armlet
