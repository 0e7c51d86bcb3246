#include <algorithm>
#include <cmath>

#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/pose.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

constexpr int kSpreadStarts = 12;  // with one start a third of the distances would be too long
constexpr int kTurnStarts = 60;    // orientations have more local minima
constexpr int kLeastSquaresSteps = 200;
constexpr double kPositionFirst = 100.0;  // weight that makes position come before orientation
constexpr double kPositionFixed = 1e4;    // and one that hardly moves it

struct Nearest {
  JointArray q{};
  IkError error;
};

// The best of several least-squares solutions; `first` starts before the `spread` ones.
template <class Measure>
Nearest nearest(const Robot& robot, const IkGoal& goal, const std::vector<JointArray>& first,
                int spread, Measure measure) {
  IkSolver solver(robot, goal);
  Nearest best;
  double smallest = INFINITY;
  const int given = static_cast<int>(first.size());
  for (int start = 0; start < given + spread; ++start) {
    JointArray q = start < given ? first[static_cast<std::size_t>(start)]
                                 : halton_start(robot, start - given + 1);
    solver.minimise_in_box(q, kLeastSquaresSteps);
    const IkError error = solver.error_of(q);
    // A later start must be better by more than rounding.
    if (measure(error) >= smallest - 1e-9) continue;
    smallest = measure(error);
    best = {q, error};
  }
  return best;
}

// The light weight traded a little of the place for orientation.
void put_in_place(const Robot& robot, const IkGoal& goal, const IkOptions& options, Nearest& near) {
  IkGoal both = goal;
  both.weights.head<3>() *= kPositionFixed;
  JointArray q = near.q;
  IkSolver(robot, both).minimise_in_box(q, kLeastSquaresSteps);
  if (!IkSolver(robot, goal.without_turn()).solve_in_box(q, options.iterations)) return;
  near = {q, IkSolver(robot, goal).error_of(q)};
}

double total_excess(const Robot& robot, const Eigen::VectorXd& q) {
  double sum = 0.0;
  for (const LimitViolation& violation : limit_violations(robot, q)) sum += violation.excess();
  return sum;
}

// The solution without limits that breaks them least; empty if there is none.
Eigen::VectorXd least_violating(const Robot& robot, const IkGoal& goal, IkOptions options) {
  options.respect_limits = false;
  std::vector<Eigen::VectorXd> solutions;
  std::vector<FormulaSolution> branches;
  FormulaAnswer answer = FormulaAnswer::kSilent;
  if (formula_applies(robot, goal, options))
    answer = solve_by_formula(robot, goal, options, branches);
  for (const FormulaSolution& branch : branches)
    solutions.push_back(to_vector(branch.q, robot.n()));
  if (answer == FormulaAnswer::kSilent || robot.n() > 6) {
    const IkSearch search = search_ik(robot, goal, options, 16, 40);
    solutions.insert(solutions.end(), search.solutions.begin(), search.solutions.end());
  }
  Eigen::VectorXd best;
  for (const Eigen::VectorXd& solution : solutions) {
    const Eigen::VectorXd q = wrap_near(robot, solution, options.seed);
    if (best.size() == 0 || total_excess(robot, q) < total_excess(robot, best) - 1e-9) best = q;
  }
  return best;
}

bool counts_rotation(const IkGoal& goal) { return !goal.weights.tail<3>().isZero(); }

// What the geometry of the arm rules out.
ReachGap gap_of(const Robot& robot, const IkGoal& goal, const IkOptions& options) {
  const bool all = (goal.weights.array() == 1.0).all();
  const bool place = (goal.weights.head<3>().array() == 1.0).all() && !counts_rotation(goal);
  if (options.method != IkMethod::kAuto || (!all && !place)) return {};
  return closed_form(robot).gap(make_pose(goal.R, goal.p), all);
}

}  // namespace

bool diagnose(const Robot& robot, const IkGoal& goal, const IkOptions& options, IkResult& result) {
  IkDiagnosis& diagnosis = result.diagnosis;

  const IkGoal place = goal.without_turn();
  Nearest best = nearest(robot, place, {to_array(options.seed), to_array(result.q)}, kSpreadStarts,
                         [](const IkError& e) { return e.position; });
  diagnosis.distance = best.error.position <= goal.position_tolerance ? 0.0 : best.error.position;
  result.status = IkStatus::kUnreachable;

  if (diagnosis.distance == 0.0 && counts_rotation(goal)) {
    IkGoal both = goal;
    both.weights.head<3>() *= kPositionFirst;
    best = nearest(robot, both, {best.q, to_array(result.q)}, kTurnStarts,
                   [](const IkError& e) { return kPositionFirst * e.position + e.rotation; });
    put_in_place(robot, goal, options, best);
    diagnosis.angle = best.error.rotation;
    result.status = IkStatus::kOrientationUnreachable;
  }
  diagnosis.q_nearest = to_vector(best.q, robot.n());
  diagnosis.nearest = forward(robot, diagnosis.q_nearest);
  if (goal.is_met(IkSolver(robot, goal).error_of(best.q))) return true;

  const Singularity near_singular = singularity(robot, diagnosis.q_nearest);
  diagnosis.sigma_min = near_singular.sigma_min;
  diagnosis.lost_direction = near_singular.direction;
  if (diagnosis.distance == 0.0 && diagnosis.angle < 1e-3 && diagnosis.sigma_min < 1e-3) {
    result.status = IkStatus::kSingularGoal;
  }

  diagnosis.gap = gap_of(robot, goal, options);

  const Eigen::VectorXd outside = least_violating(robot, goal, options);
  if (outside.size() > 0) {
    diagnosis.violations = limit_violations(robot, outside);
    if (!diagnosis.violations.empty()) result.status = IkStatus::kJointLimit;
  }
  return false;
}

}  // namespace armlet
