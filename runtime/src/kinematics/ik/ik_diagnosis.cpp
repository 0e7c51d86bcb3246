#include <algorithm>
#include <cmath>

#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/pose.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

// with one start a third of the distances would be too large
constexpr int kSpreadStarts = 12;
constexpr int kOrientationStarts = 60;  // orientations have more local minima
constexpr int kSamples = 2'000;         // of the joint space, of which the nearest are refined
constexpr std::size_t kFollowed = 32;
constexpr std::size_t kDeepest = 4;
// at the boundary of the reach there are fewer local minima
constexpr int kFewOrientationStarts = 20;
constexpr double kApart = 0.08;  // of the joints' ranges, between those
constexpr int kSampleSteps = 40;
constexpr double kSamePosition = 1e-7;  // m
constexpr int kLeastSquaresSteps = 200;
constexpr double kPositionFirst = 100.0;  // weight that gives position priority over orientation
constexpr double kPositionFixed = 1e4;    // weight that practically fixes the position

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

// The distance of two configurations, as a fraction of the joint ranges.
double parts_apart(const Robot& robot, const JointArray& a, const JointArray& b) {
  double largest = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double range = std::max(robot.upper()[i] - robot.lower()[i], 1e-9);
    largest = std::max(largest, std::abs(a[k] - b[k]) / range);
  }
  return largest;
}

// The configurations of an even sample of the joint space whose tool points are nearest to a
// position, and which are not neighbours of each other: one for each local minimum of the distance.
std::vector<JointArray> nearest_samples(const Robot& robot, const Eigen::Vector3d& p) {
  struct Sample {
    double distance = 0.0;
    JointArray q{};
  };
  std::vector<Sample> samples;
  for (int k = 1; k <= kSamples; ++k) {
    const JointArray q = halton_start(robot, k);
    const Eigen::Map<const Eigen::VectorXd> joints(q.data(), robot.n());
    samples.push_back({(forward(robot, joints).translation() - p).norm(), q});
  }
  std::ranges::stable_sort(samples, {}, &Sample::distance);
  std::vector<JointArray> out;
  for (const Sample& sample : samples) {
    if (out.size() >= kFollowed) break;
    const auto is_near = [&](const JointArray& q) {
      return parts_apart(robot, q, sample.q) < kApart;
    };
    if (std::ranges::none_of(out, is_near)) out.push_back(sample.q);
  }
  return out;
}

// The smallest local minimum: each is refined a little, and the best few completely.
Nearest nearest_position(const Robot& robot, const IkGoal& goal, std::vector<JointArray> starts) {
  for (const JointArray& q : nearest_samples(robot, goal.p)) starts.push_back(q);
  for (int k = 1; k <= kSpreadStarts; ++k) starts.push_back(halton_start(robot, k));
  IkSolver solver(robot, goal);
  std::vector<Nearest> valleys;
  for (JointArray& q : starts) {
    solver.minimise_in_box(q, kSampleSteps);
    valleys.push_back({q, solver.error_of(q)});
  }
  const auto distance = [](const Nearest& n) { return n.error.position; };
  std::ranges::stable_sort(valleys, {}, distance);
  std::vector<JointArray> best;
  for (std::size_t k = 0; k < std::min(valleys.size(), kDeepest); ++k) best.push_back(valleys[k].q);
  return nearest(robot, goal, best, 0, [](const IkError& e) { return e.position; });
}

// Moves the tool point to the position, of which the smaller weight has given up a little for the
// orientation.
void put_at_position(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                     Nearest& near) {
  IkGoal both = goal;
  both.weights.head<3>() *= kPositionFixed;
  JointArray q = near.q;
  IkSolver(robot, both).minimise_in_box(q, kLeastSquaresSteps);
  if (!IkSolver(robot, goal.without_orientation()).solve_in_box(q, options.iterations)) return;
  near = {q, IkSolver(robot, goal).error_of(q)};
}

// Among the configurations with this position, finds the one with the nearest orientation.
void orient_at_position(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                        const JointArray& q_failed, int starts, Nearest& best) {
  IkGoal there = goal;
  there.p =
      forward(robot, Eigen::Map<const Eigen::VectorXd>(best.q.data(), robot.n())).translation();
  IkGoal both = there;
  both.weights.head<3>() *= kPositionFirst;
  Nearest turned = nearest(robot, both, {best.q, q_failed}, starts, [](const IkError& e) {
    return kPositionFirst * e.position + e.rotation;
  });
  put_at_position(robot, there, options, turned);
  IkSolver solver(robot, goal);
  turned.error = solver.error_of(turned.q);
  best.error = solver.error_of(best.q);
  const bool same_position = turned.error.position <=
                             std::max(best.error.position + kSamePosition, goal.position_tolerance);
  if (same_position && turned.error.rotation < best.error.rotation) best = turned;
}

double total_excess(const Robot& robot, const Eigen::VectorXd& q) {
  double sum = 0.0;
  for (const LimitViolation& violation : limit_violations(robot, q)) sum += violation.excess();
  return sum;
}

// The solution without limits that exceeds them least; empty if there is none.
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

// The gap that the geometry of the arm causes.
ReachGap gap_of(const Robot& robot, const IkGoal& goal, const IkOptions& options) {
  const bool all = (goal.weights.array() == 1.0).all();
  const bool position_only =
      (goal.weights.head<3>().array() == 1.0).all() && !counts_rotation(goal);
  if (options.method != IkMethod::kAuto || (!all && !position_only)) return {};
  return closed_form(robot).gap(make_pose(goal.R, goal.p), all);
}

}  // namespace

bool diagnose(const Robot& robot, const IkGoal& goal, const IkOptions& options, IkResult& result) {
  IkDiagnosis& diagnosis = result.diagnosis;

  Nearest best = nearest_position(robot, goal.without_orientation(),
                                  {to_array(options.seed), to_array(result.q)});
  const bool at_position = best.error.position <= goal.position_tolerance;
  diagnosis.distance = at_position ? 0.0 : best.error.position;
  result.status = IkStatus::kUnreachable;
  if (counts_rotation(goal)) {
    orient_at_position(robot, goal, options, to_array(result.q),
                       at_position ? kOrientationStarts : kFewOrientationStarts, best);
    diagnosis.angle = best.error.rotation;
    if (at_position) result.status = IkStatus::kOrientationUnreachable;
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
