#include "armlet/kinematics/ik_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/pose.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

BranchReport report_branch(const Robot& robot, const Eigen::VectorXd& seed, int branch,
                           const Eigen::VectorXd& q) {
  BranchReport out;
  out.name = closed_form(robot).branch_name(branch);
  out.q = wrap_near(robot, q, seed);
  out.outside = limit_violations(robot, out.q);
  Eigen::Index joint = 0;
  out.change = (out.q - seed).cwiseAbs().maxCoeff(&joint);
  out.joint = static_cast<int>(joint);
  return out;
}

std::string solver_line(const Robot& robot, const IkReport& report) {
  if (report.kind == ClosedFormKind::kNone) {
    return fmt::format("{}: no closed form fits its structure, so it is solved by iterations",
                       robot.name());
  }
  std::string text = fmt::format("{}: closed form for {}", robot.name(), to_text(report.kind));
  if (report.reversed) text += ", read from the tool to the base";
  if (report.held_joint >= 0)
    text += fmt::format(", with joint {} held where it is", report.held_joint + 1);
  return text;
}

std::string beyond(const Robot& robot, const LimitViolation& v) {
  const JointKind kind = robot.joint(v.joint).kind;
  return fmt::format("joint {} would {} to {}, {} beyond its limit of {}", v.joint + 1,
                     joint_word(kind), format_joint_value(kind, v.value, v.limit),
                     format_joint_value(kind, v.excess(), 0.0), format_joint_value(kind, v.limit));
}

std::string branch_line(const Robot& robot, const BranchReport& branch, bool taken) {
  std::string text =
      fmt::format("{} {}: ", taken ? '>' : ' ', branch.name.empty() ? "the only way" : branch.name);
  if (branch.outside.empty()) {
    const JointKind kind = robot.joint(branch.joint).kind;
    return text + fmt::format("within the limits; joint {} moves most, by {}", branch.joint + 1,
                              format_joint_value(kind, branch.change));
  }
  for (std::size_t i = 0; i < branch.outside.size(); ++i)
    text += (i > 0 ? "; " : "") + beyond(robot, branch.outside[i]);
  return text;
}

// The nearest reachable pose, as a line of the report.
std::string nearest_line(const Robot& robot, const IkResult& result) {
  std::string joints;
  for (int i = 0; i < robot.n(); ++i) {
    if (i > 0) joints += ", ";
    joints += format_joint_value(robot.joint(i).kind, result.diagnosis.q_nearest[i]);
  }
  return fmt::format("nearest pose: {}, with the joints at {}",
                     format_pose(result.diagnosis.nearest), joints);
}

std::string posture_line(Posture posture) {
  const auto what = [&]() -> std::string_view {
    switch (posture) {
      case Posture::kMidRange:
        return "the middle of the joints' ranges is nearest";
      case Posture::kManipulability:
        return "singularities are farthest";
      case Posture::kNearGiven:
        break;
    }
    return "the given posture is nearest";
  }();
  return fmt::format("chosen because there {}", what);
}

}  // namespace

IkReport report_ik(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                   const IkOptions& given) {
  IkOptions options = given;
  if (options.seed.size() == 0) options.seed = robot.home();
  IkReport report;
  const ClosedForm& closed = closed_form(robot);
  report.kind = closed.kind();
  report.reversed = closed.reversed();
  report.held_joint = closed.held_joint();
  if (options.posture) report.posture = options.posture->posture;
  report.result = solve_ik(robot, T_world_tool, options);
  const IkStatus status = report.result.status;
  const bool asked = status != IkStatus::kBadSize && status != IkStatus::kNotFinite &&
                     status != IkStatus::kBadRotation;
  if (!asked || !closed.exists()) return report;
  IkGoal goal = make_goal(robot, T_world_tool, options);
  if (options.task == IkTask::kPositionFirst) {
    if (closed.position_only())
      goal = goal.without_orientation();
    else if (report.result.ok())
      goal.R = forward(robot, report.result.q).linear();
  }
  if (!formula_applies(robot, goal, options)) return report;
  // The branches at the arm angle of the answer, if the arm has one.
  const Eigen::VectorXd seed = options.seed;
  if (report.result.ok() && robot.n() > 6) options.seed = report.result.q;
  options.respect_limits = false;
  std::vector<FormulaSolution> solutions;
  solve_by_formula(robot, goal, options, solutions);
  for (const FormulaSolution& solution : solutions) {
    // In the chosen branch, joints that the goal leaves free have the values of the answer.
    const bool taken = report.result.ok() && solution.branch == report.result.branch;
    report.branches.push_back(report_branch(
        robot, seed, solution.branch, taken ? report.result.q : to_vector(solution.q, robot.n())));
  }
  std::ranges::stable_sort(report.branches, [](const BranchReport& a, const BranchReport& b) {
    return a.change < b.change;
  });
  return report;
}

std::string to_text(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                    const IkReport& report) {
  const IkResult& result = report.result;
  std::string text = solver_line(robot, report);
  if (!report.branches.empty()) {
    std::size_t usable = 0;
    for (const BranchReport& branch : report.branches) usable += branch.outside.empty() ? 1 : 0;
    text += fmt::format("\n{} branch{}, {} within the limits", report.branches.size(),
                        report.branches.size() == 1 ? "" : "es", usable);
  }
  for (const BranchReport& branch : report.branches) {
    const bool taken = result.ok() && branch.outside.empty() &&
                       largest_change(wrap_near(robot, branch.q, result.q), result.q) < 1e-6;
    text += "\n" + branch_line(robot, branch, taken);
  }
  if (!result.ok()) {
    text += "\n" + explain(robot, T_world_tool, result);
    return result.diagnosis.q_nearest.size() > 0 ? text + "\n" + nearest_line(robot, result) : text;
  }
  if (result.solver == kStands) {
    text += "\nthe robot stands there already";
  } else if (result.branch < 0) {
    text += fmt::format("\nsolved by iterations: {} in {} start{}", result.iterations,
                        result.starts, result.starts == 1 ? "" : "s");
  }
  if (report.posture) text += "\n" + posture_line(*report.posture);
  Eigen::Index joint = 0;
  result.margins.minCoeff(&joint);
  const JointKind kind = robot.joint(static_cast<int>(joint)).kind;
  return text + fmt::format("\nnearest to a limit: joint {}, {} away", joint + 1,
                            format_joint_value(kind, result.margins[joint]));
}

}  // namespace armlet
