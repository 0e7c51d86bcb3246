#include <algorithm>
#include <cmath>
#include <optional>

#include "armlet/kinematics/null_space.hpp"
#include "ik_search.hpp"
#include "ik_wished.hpp"

namespace armlet {
namespace {

constexpr int kCandidates = 16;   // solutions that are compared
constexpr int kStarts = 192;      // for a redundant arm, around the desired posture
constexpr double kBetter = 1e-9;  // of a value: less is rounding

struct Candidate {
  Eigen::VectorXd q;
  int branch = -1;
};

// The rows of the task; an arm with more joints than rows can move without changing them.
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

// The joint values of the best posture; nothing for manipulability.
std::optional<Eigen::VectorXd> wished_values(const Robot& robot, const PostureGoal& goal) {
  switch (goal.posture) {
    case Posture::kManipulability:
      break;
    case Posture::kMidRange:
      return 0.5 * (robot.lower() + robot.upper());
    case Posture::kNearGiven:
      return goal.q_given;
  }
  return std::nullopt;
}

// Joint values and ranges for the search; nothing without finite limits.
std::optional<WishedJoints> wished_joints(const Robot& robot,
                                          const std::optional<Eigen::VectorXd>& values) {
  if (!values || !robot.lower().allFinite() || !robot.upper().allFinite()) return std::nullopt;
  return WishedJoints{*values, robot.upper() - robot.lower()};
}

// A start for the iterations: no joint is farther from its desired value than it could be in a
// posture of this cost with all other joints at their desired values.
JointArray start_around(const Robot& robot, const WishedJoints& wished, double cost, int index) {
  JointArray q{};
  const double far = std::sqrt(2.0 * cost);
  for (int i = 0; i < robot.n(); ++i) {
    const double reach = far * wished.range[i];
    const double low = std::clamp(wished.q[i] - reach, robot.lower()[i], robot.upper()[i]);
    const double high = std::clamp(wished.q[i] + reach, robot.lower()[i], robot.upper()[i]);
    q[static_cast<std::size_t>(i)] = low + (high - low) * halton_share(i, index);
  }
  return q;
}

// Finds the solution of least cost of a redundant arm by searches from starts around the desired
// values. Each better solution reduces the region in which others can be.
void search_around(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   const WishedJoints& wished, IkResult& result) {
  IkSolver solver(robot, goal);
  JointArray best = to_array(result.q);
  double cost = wished.cost(best);
  const double before = cost;
  for (int start = 1; start <= kStarts; ++start) {
    JointArray found = start_around(robot, wished, cost, start);
    if (!solver.solve_in_box(found, options.iterations)) continue;
    const Eigen::VectorXd q = wrap_near(robot, to_vector(found, robot.n()), wished.q);
    found = to_array(clamp_to_limits(robot, q));
    slide_to_wished(robot, solver, wished, found);
    if (!(wished.cost(found) < cost) || !goal.is_met(solver.error_of(found))) continue;
    best = found;
    cost = wished.cost(found);
  }
  if (!(cost < before * (1.0 - kBetter))) return;
  const IkError error = solver.error_of(best);
  result.q = to_vector(best, robot.n());
  result.posture = posture_value(robot, result.q, *options.posture);
  result.position_error = error.position;
  result.rotation_error = error.rotation;
  result.margins = limit_margins(robot, result.q);
  result.branch = -1;
  result.solver = IkResult().solver;
}

// A solution of a redundant arm, improved by self-motion.
Eigen::VectorXd moved(const Robot& robot, IkSolver& solver, const PostureGoal& goal,
                      const std::optional<WishedJoints>& wished, const TaskRows& rows,
                      const Eigen::VectorXd& q) {
  if (!wished) return improve_posture(robot, q, goal, rows);
  JointArray at = to_array(q);
  slide_to_wished(robot, solver, *wished, at);
  return to_vector(at, robot.n());
}

}  // namespace

void take_best_posture(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                       const IkGoal& goal, const IkOptions& options, IkResult& result) {
  const PostureGoal& wish = *options.posture;
  const TaskRows rows = rows_of(goal);
  const auto counting = std::count(rows.counts.begin(), rows.counts.end(), true);
  const bool spare = robot.n() > counting && options.respect_limits;
  IkSolver solver(robot, goal);
  const std::optional<Eigen::VectorXd> values = wished_values(robot, wish);
  const std::optional<WishedJoints> wished = spare ? wished_joints(robot, values) : std::nullopt;
  bool any = false;
  for (Candidate& candidate : candidates_for(robot, T_world_tool, goal, options, result)) {
    Eigen::VectorXd q = candidate.q;
    if (options.respect_limits && values) q = wrap_near(robot, q, *values);
    if (spare) q = moved(robot, solver, wish, wished, rows, clamp_to_limits(robot, q));
    const IkError error = solver.error_of(to_array(q));
    if (!goal.is_met(error)) continue;
    const double value = posture_value(robot, q, wish);
    // Later candidates have to be better by more than rounding.
    if (any && value <= result.posture + kBetter * std::abs(result.posture)) continue;
    any = true;
    result.posture = value;
    result.position_error = error.position;
    result.rotation_error = error.rotation;
    result.margins = limit_margins(robot, q);
    const bool is_moved = spare && largest_change(q, candidate.q) > 1e-9;
    result.branch = is_moved ? -1 : candidate.branch;
    if (result.branch >= 0) result.solver = to_text(closed_form(robot).kind());
    result.q = std::move(q);
  }
  if (wished && any) search_around(robot, goal, options, *wished, result);
}

}  // namespace armlet
