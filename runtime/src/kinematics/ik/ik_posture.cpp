#include <algorithm>

#include "armlet/kinematics/null_space.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

constexpr int kCandidates = 16;  // solutions that are compared

struct Candidate {
  Eigen::VectorXd q;
  int branch = -1;
};

// The rows that count; an arm with more joints than those can move without changing them.
TaskRows rows_of(const IkGoal& goal) {
  TaskRows rows;
  for (std::size_t i = 0; i < 6; ++i)
    rows.counts[i] = goal.weights[static_cast<Eigen::Index>(i)] != 0.0;
  if (goal.in_tool_axes) rows.axes = JacobianFrame::kTool;
  return rows;
}

std::vector<Candidate> candidates_for(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                                      const IkGoal& goal, const IkOptions& options,
                                      const IkResult& result) {
  std::vector<Candidate> out = {{result.q, result.branch}};
  if (formula_applies(robot, goal, options) && closed_form(robot).complete()) {
    std::vector<FormulaSolution> branches;
    solve_by_formula(robot, goal, options, branches);
    for (const FormulaSolution& branch : branches)
      out.push_back({to_vector(branch.q, robot.n()), branch.branch});
    return out;
  }
  for (Eigen::VectorXd& other : solve_ik_all(robot, T_world_tool, options, kCandidates))
    out.push_back({std::move(other)});
  return out;
}

// The copy of the revolute joints that suits the posture.
Eigen::VectorXd improved_posture(const Robot& robot, const Eigen::VectorXd& q,
                                 const PostureGoal& goal) {
  switch (goal.posture) {
    case Posture::kManipulability:
      break;
    case Posture::kMidRange:
      return wrap_near(robot, q, 0.5 * (robot.lower() + robot.upper()));
    case Posture::kNearGiven:
      return wrap_near(robot, q, goal.q_given);
  }
  return q;
}

}  // namespace

void take_best_posture(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                       const IkGoal& goal, const IkOptions& options, IkResult& result) {
  const PostureGoal& wish = *options.posture;
  const TaskRows rows = rows_of(goal);
  const auto counting = std::count(rows.counts.begin(), rows.counts.end(), true);
  const bool spare = robot.n() > counting && options.respect_limits;
  IkSolver solver(robot, goal);
  bool any = false;
  for (Candidate& candidate : candidates_for(robot, T_world_tool, goal, options, result)) {
    Eigen::VectorXd q = candidate.q;
    if (options.respect_limits) q = improved_posture(robot, q, wish);
    if (spare) q = improve_posture(robot, clamp_to_limits(robot, q), wish, rows);
    const IkError error = solver.error_of(to_array(q));
    if (!goal.is_met(error)) continue;
    const double value = posture_value(robot, q, wish);
    // Later candidates have to be better by more than rounding.
    if (any && value <= result.posture + 1e-9 * std::abs(result.posture)) continue;
    any = true;
    result.posture = value;
    result.position_error = error.position;
    result.rotation_error = error.rotation;
    result.margins = limit_margins(robot, q);
    const bool moved = spare && largest_change(q, candidate.q) > 1e-9;
    result.branch = moved ? -1 : candidate.branch;
    if (result.branch >= 0) result.solver = to_text(closed_form(robot).kind());
    result.q = std::move(q);
  }
}

}  // namespace armlet
