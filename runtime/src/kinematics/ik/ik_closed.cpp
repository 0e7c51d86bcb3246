#include "ik_closed.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"
#include "ik_free.hpp"
#include "ik_scan.hpp"
#include "ik_search.hpp"
#include "kinematics/self_motion/self_motion.hpp"

namespace armlet {
namespace {

constexpr int kArmAngles = 36;  // of a revolution, tried for an arm of seven joints
constexpr double kArmStep = 2.0 * kPi / kArmAngles;

// Amount by which a joint may exceed its limit by rounding, near a singularity; it is set to the
// limit and the goal is checked again.
constexpr double kRounding = 1e-6;

// Near a singularity, joint values that are exact enough for a position may leave an orientation
// error, up to this many rad, which iterations then remove.
constexpr double kNearlyOriented = 0.1;

// For an elbow stretched at its limit and a nearly singular wrist, rounding may exceed the limit by
// this; at the limit the goal is met as exactly as elsewhere, m and rad.
constexpr double kFarBeyond = 1e-3;
constexpr double kExactly = 1e-9;

constexpr int kNearStarts = 4;     // around the seed, for following curves
constexpr int kBranchStarts = 24;  // within the joint change of the nearest branch
constexpr double kRevolution = 2.0 * kPi;

// If a joint moves the tool by less, m or rad per rad or m, rounding determines its value in the
// closed form.
constexpr double kAllButIdle = 1e-8;

constexpr double kSame = 1e-6;  // rad or m, of solutions and their changes
constexpr double kTie = 1e-7;   // rad or m; between equal changes the given value decides

bool counts_all(const IkGoal& goal) { return (goal.weights.array() == 1.0).all(); }
bool counts_position(const IkGoal& goal) {
  return (goal.weights.head<3>().array() == 1.0).all() && goal.weights.tail<3>().isZero();
}

// Puts joints that lie beyond a limit by rounding back onto it.
bool put_inside(const Robot& robot, JointArray& q) {
  bool moved = false;
  for (int i = 0; i < robot.n(); ++i) {
    double& value = q[static_cast<std::size_t>(i)];
    const double inside = std::clamp(value, robot.lower()[i], robot.upper()[i]);
    moved = moved || inside != value;
    value = inside;
  }
  return moved;
}

// Joints that were set to their limits meet the goal within its tolerance only; this looks for
// nearby values that meet it exactly.
void make_exact(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q) {
  IkGoal exact = goal;
  exact.position_tolerance = exact.rotation_tolerance = kExactly;
  IkSolver solver(robot, exact);
  JointArray better = q;
  if (exact.is_met(solver.error_of(q)) || !solver.solve_in_box(better, options.iterations)) return;
  if (change_of(better, to_vector(q, robot.n())) < kFarBeyond) q = better;
}

// A solution of the closed form at the copies nearest to the seed, inside the limits if they apply,
// and checked again if that changes it. False if there is none.
bool settle_in(const Robot& robot, const IkGoal& goal, const IkOptions& options, bool shares,
               bool check, JointArray& q) {
  if (bring_near(robot, goal, options, shares, q) > kRounding) return false;
  const bool moved = options.respect_limits && put_inside(robot, q);
  if (!moved && !check && !shares) return true;
  IkSolver solver(robot, goal);
  const IkError error = solver.error_of(q);
  if (goal.is_met(error)) {
    if (moved) make_exact(robot, goal, options, q);
    return true;
  }
  if (error.rotation >= kNearlyOriented) return false;
  return options.respect_limits ? solver.solve_in_box(q, options.iterations)
                                : solver.solve_free(q, options.iterations);
}

// The same for joints that may share an angle: the closed form's values are kept if no others are
// nearer.
bool settle_near(const Robot& robot, const IkGoal& goal, const IkOptions& options, bool free,
                 bool check, JointArray& q) {
  if (!free) return settle_in(robot, goal, options, false, check, q);
  JointArray as_found = q;
  const bool found = settle_in(robot, goal, options, false, check, as_found);
  if (settle_in(robot, goal, options, true, check, q) &&
      !(found && change_of(as_found, options.seed) <= change_of(q, options.seed) + kTie))
    return true;
  q = as_found;
  return found;
}

// Whether a solution could be nearer: one with no joint beyond half a revolution from the seed
// could not.
bool is_far(const IkOptions& options, bool settled, const JointArray& q) {
  return options.respect_limits && (!settled || change_of(q, options.seed) > kPi);
}

// A solution of the closed form that exceeds limits slightly, moved to them.
bool settle_on_limits(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                      JointArray& q) {
  wrap_to_seed(robot, options, q, kFarBeyond);
  for (int i = 0; i < robot.n(); ++i) {
    const double value = q[static_cast<std::size_t>(i)];
    if (value < robot.lower()[i] - kFarBeyond || value > robot.upper()[i] + kFarBeyond)
      return false;
  }
  put_inside(robot, q);
  const Eigen::VectorXd on_limits = to_vector(q, robot.n());
  IkSolver solver(robot, goal);
  if (!solver.solve_in_box(q, options.iterations)) return false;
  if (change_of(q, on_limits) > kFarBeyond) return false;  // another branch
  const IkError error = solver.error_of(q);
  return error.position < kExactly && error.rotation < kExactly;
}

// Whether two solutions are equal modulo whole revolutions.
bool is_same(const Robot& robot, const JointArray& a, const JointArray& b) {
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double change = std::abs(a[k] - b[k]);
    if (change <= kSame) continue;
    if (change < 2.0 * kPi - kSame || !robot.is_revolute(i) ||
        std::abs(angle_difference(a[k], b[k])) > kSame)
      return false;
  }
  return true;
}

void add_new(const Robot& robot, const FormulaSolution& solution,
             std::vector<FormulaSolution>& solutions) {
  const auto same = [&](const FormulaSolution& s) { return is_same(robot, s.q, solution.q); };
  if (std::ranges::none_of(solutions, same)) solutions.push_back(solution);
}

FormulaSolution& nearest_in(std::vector<FormulaSolution>& solutions, const IkOptions& options) {
  const auto change = [&](const FormulaSolution& s) { return change_of(s.q, options.seed); };
  return *std::ranges::min_element(solutions, {}, change);
}

// For each branch the solution over all values of an open joint, if it is nearer than the one with
// the present value.
void take_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                 const std::vector<FormulaSolution>& found,
                 std::vector<FormulaSolution>& solutions) {
  for (FormulaSolution candidate : found) {
    if (!settle_near(robot, goal, options, true, true, candidate.q)) continue;
    const auto at = std::ranges::find(solutions, candidate.branch, &FormulaSolution::branch);
    if (at == solutions.end())
      add_new(robot, candidate, solutions);
    else if (change_of(candidate.q, options.seed) < change_of(at->q, options.seed) - kSame)
      *at = candidate;
  }
  std::ranges::sort(solutions, {}, &FormulaSolution::branch);
  if (solutions.empty()) return;
  // Moves along the solutions for the distance to the nearest one that the scan has left.
  slide_nearer(robot, goal, options, nearest_in(solutions, options).q);
}

// Follows solutions from starts around the seed, where the scan may have missed a narrow interval.
void follow_near(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                 std::vector<FormulaSolution>& solutions) {
  std::vector<Eigen::VectorXd> around;
  search_near(robot, goal, options, kNearStarts, around);
  for (const Eigen::VectorXd& start : around) {
    FormulaSolution found{to_array(start), -1};
    slide_nearer(robot, goal, options, found.q);
    wrap_to_seed(robot, options, found.q);
    const auto nearer = [&](const FormulaSolution& s) {
      return change_of(s.q, options.seed) <= change_of(found.q, options.seed) + kSame;
    };
    if (std::ranges::none_of(solutions, nearer)) add_new(robot, found, solutions);
  }
}

// Follows the curves of solutions, which continue where a branch of the closed form ends: there a
// joint changes like a square root of the open one, and an interval between limits can be too
// narrow for the scan. A curve may even lie between the samples; starts near the seed lead to it.
void follow_branches(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                     const ClosedSolutions& found, std::vector<FormulaSolution>& solutions) {
  SelfMotions curves(robot, goal, options);
  for (const FormulaSolution& solution : solutions) curves.follow(solution.q);
  for (const ClosedSolution& solution : found) curves.follow(solution.q);
  double change = INFINITY;
  for (const FormulaSolution& solution : solutions)
    change = std::min(change, change_of(solution.q, options.seed));
  const double known = change;
  if (!(known <= kRevolution)) change = kRevolution;
  IkSolver solver(robot, goal);
  for (int start = 1; start <= kBranchStarts; ++start) {
    JointArray q = start_within(robot, options, change, start);
    if (solver.solve_free(q, options.iterations)) curves.follow(q);
  }
  change = known;
  FormulaSolution nearer{{}, -1};
  if (curves.bring_nearer(nearer.q, change) && change < known - kSame)
    add_new(robot, nearer, solutions);
}

void search_open_joints(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                        const ClosedSolutions& formula, bool nearest_only,
                        std::vector<FormulaSolution>& solutions) {
  const unsigned open = formula.open;
  Eigen::VectorXd near = options.seed;
  const int rounds = (open & (open - 1)) != 0 ? 2 : 1;  // several of them alternately
  for (int round = 0; round < rounds; ++round) {
    for (int joint = 0; joint < robot.n(); ++joint) {
      if ((open >> joint & 1U) == 0) continue;
      const auto found = scan_open_joint(robot, goal, options, joint, near, nearest_only);
      take_nearer(robot, goal, options, found, solutions);
      if (!solutions.empty())
        near[joint] =
            nearest_branch(robot, options.seed, solutions).q[static_cast<std::size_t>(joint)];
    }
  }
  follow_near(robot, goal, options, solutions);
  if (rounds == 1) follow_branches(robot, goal, options, formula, solutions);
}

}  // namespace

bool formula_applies(const Robot& robot, const IkGoal& goal, const IkOptions& options) {
  if (options.method != IkMethod::kAuto) return false;
  const ClosedForm& closed = closed_form(robot);
  if (!closed.exists()) return false;
  return counts_all(goal) || (closed.position_only() && counts_position(goal));
}

FormulaAnswer solve_by_formula(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                               std::vector<FormulaSolution>& solutions, double arm_angle_change,
                               bool nearest_only) {
  const ClosedForm& closed = closed_form(robot);
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() = goal.R;
  T_world_tool.translation() = goal.p;
  ClosedSolutions found;
  closed.solve(T_world_tool, options.seed, found,
               std::min(goal.position_tolerance, goal.rotation_tolerance), arm_angle_change);
  const bool check_rotation = closed.position_only() && counts_all(goal);
  for (const ClosedSolution& solution : found) {
    FormulaSolution candidate{solution.q, solution.branch};
    const bool settled = settle_near(robot, goal, options, found.free, check_rotation, candidate.q);
    if (FormulaSolution edge{solution.q, solution.branch};
        is_far(options, settled, candidate.q) && settle_on_limits(robot, goal, options, edge.q) &&
        (!settled || change_of(edge.q, options.seed) < change_of(candidate.q, options.seed)))
      add_new(robot, edge, solutions);
    else if (settled)
      add_new(robot, candidate, solutions);
  }
  if (found.open != 0 && robot.n() <= 6 && counts_all(goal))
    search_open_joints(robot, goal, options, found, nearest_only, solutions);
  else if (found.free && nearest_only && counts_all(goal) && !solutions.empty())
    slide_nearer(robot, goal, options, nearest_in(solutions, options).q, kAllButIdle);
  const bool all = closed.complete() && !found.free;
  if (solutions.empty()) return all ? FormulaAnswer::kNone : FormulaAnswer::kSilent;
  return all ? FormulaAnswer::kAll : FormulaAnswer::kSome;
}

std::vector<FormulaSolution> solve_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                   const IkOptions& options) {
  std::vector<FormulaSolution> solutions;
  for (int k = 0; k < kArmAngles && solutions.empty(); ++k) {
    // Steps in the order 0, +1, -1, +2, -2, ...
    const int step = k % 2 == 1 ? (k + 1) / 2 : -k / 2;
    solve_by_formula(robot, goal, options, solutions, step * kArmStep);
  }
  return solutions;
}

std::vector<FormulaSolution> nearest_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                     const IkOptions& options) {
  std::vector<FormulaSolution> solutions;
  const auto found = scan_open_joint(robot, goal, options, kArmAngle, options.seed, true);
  take_nearer(robot, goal, options, found, solutions);
  std::ranges::stable_sort(solutions, {},
                           [&](const FormulaSolution& s) { return change_of(s.q, options.seed); });
  return solutions;
}

}  // namespace armlet
