#include <algorithm>
#include <cmath>

#include "ik_free.hpp"
#include "ik_minimax.hpp"
#include "ik_search.hpp"
#include "kinematics/self_motion/self_motion.hpp"

namespace armlet {
namespace {

constexpr std::size_t kSlid = 4;      // number of solutions of the iterations that are moved,
constexpr std::size_t kSlidOne = 16;  // and the number if each has one free direction
constexpr int kCurveStarts = 24;      // within the joint change of the nearest solution
constexpr double kNoNearer = 1e-6;    // rad or m
constexpr int kWideStarts = 192;    // the same, where solutions are connected in several directions
constexpr double kPromising = 0.5;  // rad or m; solutions farther than that are not moved

// Divides shared angles of the solutions of the iterations anew, and sorts the solutions.
void divide_shares(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   std::vector<Eigen::VectorXd>& solutions) {
  IkSolver solver(robot, goal);
  for (Eigen::VectorXd& solution : solutions) {
    JointArray q = to_array(solution);
    const bool inside = bring_near(robot, goal, options, true, q) <= 0.0;
    if (inside && goal.is_met(solver.error_of(q)) &&
        change_of(q, options.seed) < largest_change(solution, options.seed))
      solution = to_vector(q, robot.n());
  }
  sort_by_nearness(robot, options.seed, solutions);
}

// Searches the curves, and those that starts near the seed lead to: a solution nearer than the
// nearest known one, which comes first, is within its joint change.
void search_curves(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   SelfMotions& curves, std::vector<Eigen::VectorXd>& solutions) {
  JointArray q = to_array(solutions.front());
  double change = change_of(q, options.seed);
  curves.follow_neighbours();
  bool nearer = curves.bring_nearer(q, change);
  IkSolver solver(robot, goal);
  for (int start = 1; start <= kCurveStarts; ++start) {
    JointArray found = start_within(robot, options, change, start);
    if (!solver.solve_free(found, options.iterations)) continue;
    if (curves.follow(found) == SelfMotions::Found::kCurve) {
      nearer = curves.bring_nearer(q, change) || nearer;
      continue;
    }
    if (bring_near(robot, goal, options, true, found) > 0.0) continue;
    if (!goal.is_met(solver.error_of(found))) continue;
    if (change_of(found, options.seed) >= change - kNoNearer) continue;
    q = found;
    change = change_of(found, options.seed);
    nearer = true;
  }
  if (nearer) solutions.insert(solutions.begin(), to_vector(q, robot.n()));
}

// Searches the nearest solution where solutions form surfaces: many starts within the joint change
// of the nearest solution, each moved as near as possible.
void search_surfaces(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                     std::vector<Eigen::VectorXd>& solutions) {
  IkSolver solver(robot, goal);
  JointArray q = to_array(solutions.front());
  double change = change_of(q, options.seed);
  bool nearer = false;
  for (int start = 1; start <= kWideStarts; ++start) {
    JointArray found = start_within(robot, options, change, start);
    const bool met = options.respect_limits ? solver.solve_in_box(found, options.iterations)
                                            : solver.solve_free(found, options.iterations);
    if (!met || change_of(found, options.seed) > change + kPromising) continue;
    slide_nearer(robot, goal, options, found);
    if (change_of(found, options.seed) >= change - kNoNearer) continue;
    q = found;
    change = change_of(found, options.seed);
    nearer = true;
  }
  if (nearer) solutions.insert(solutions.begin(), to_vector(q, robot.n()));
}

// Whether the solutions of an arm of more than six joints form surfaces whose dimension the search
// supports. Arms of six joints or fewer use the faster search.
bool has_surfaces(const Robot& robot, const IkGoal& goal) {
  const Eigen::Index idle = robot.n() - (goal.weights.array() != 0.0).count();
  return robot.n() > 6 && idle >= 2 && idle <= kMostIdle;
}

}  // namespace

JointArray start_within(const Robot& robot, const IkOptions& options, double change, int index) {
  JointArray q{};
  for (int i = 0; i < robot.n(); ++i) {
    double low = options.seed[i] - change, high = options.seed[i] + change;
    if (options.respect_limits) {
      low = std::max(low, robot.lower()[i]);
      high = std::min(high, robot.upper()[i]);
    }
    q[static_cast<std::size_t>(i)] = low + (high - low) * halton_share(i, index);
  }
  return q;
}

void bring_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                  std::vector<Eigen::VectorXd>& solutions) {
  divide_shares(robot, goal, options, solutions);
  SelfMotions curves(robot, goal, options);
  std::size_t slid = kSlidOne;
  for (std::size_t k = 0; k < solutions.size(); ++k) {
    if (k >= slid && curves.empty()) break;
    JointArray q = to_array(solutions[k]);
    if (curves.follow(q) != SelfMotions::Found::kOther || k >= slid) continue;
    if (slide_nearer(robot, goal, options, q)) slid = kSlid;
    solutions[k] = to_vector(q, robot.n());
  }
  sort_by_nearness(robot, options.seed, solutions);
  if (has_surfaces(robot, goal)) search_surfaces(robot, goal, options, solutions);
  if (!curves.empty()) search_curves(robot, goal, options, curves, solutions);
}

}  // namespace armlet
