#include "ik_branches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/kinematics/jacobian.hpp"
#include "math/solvers.hpp"
#include "self_motion.hpp"

namespace armlet {
namespace {

constexpr int kCurveStarts = 6;   // of each row that is left out
constexpr double kExact = 1e-12;  // m and rad
constexpr int kExactly = 100;     // iterations
constexpr double kApart = 2e-6;   // rad or m; solutions that are closer are one
// Of single solutions there are no more (D. Manocha, J. F. Canny, Efficient inverse kinematics for
// general 6R manipulators, 1994).
constexpr std::size_t kMostSingle = 16;
constexpr double kAside = 0.02;     // rad or m
constexpr double kSafeShare = 0.5;  // of the least singular value, that a change may be

class BranchSearch {
 public:
  BranchSearch(const Robot& robot, const IkGoal& goal, const IkOptions& options,
               std::vector<Eigen::VectorXd>& solutions)
      : robot_(robot),
        goal_(exactly(goal)),
        options_(options),
        solver_(robot, goal_),
        solutions_(solutions) {}

  void run() {
    const std::size_t given = solutions_.size();
    std::vector<Eigen::VectorXd> others;  // those of whole curves, and what only nearly is one
    for (const Eigen::VectorXd& solution : std::exchange(solutions_, {})) {
      JointArray q = to_array(solution);
      if (!solver_.solve_free(q, kExactly) || !take_exact(q)) others.push_back(solution);
    }
    for (Eigen::Index row = 0; row < 6; ++row) {
      if (goal_.weights[row] != 0.0) leave_out(row);
    }
    for (const Eigen::VectorXd& solution : others) {
      if (solutions_.size() < given && is_new(robot_, solutions_, solution))
        solutions_.push_back(solution);
    }
  }

 private:
  // Next to a singularity many configurations meet the usual tolerances.
  static IkGoal exactly(IkGoal goal) {
    goal.position_tolerance = goal.rotation_tolerance = kExact;
    return goal;
  }

  // Whether the goal is met all along a direction. Two solutions all but one are idle there too,
  // but the iterations lead back to them.
  bool is_on_curve(const JointArray& q) {
    const JointDirections idle = idle_directions(robot_, goal_, q, kIdleTool);
    if (idle.cols() == 0) return false;
    JointArray aside = q;
    for (std::size_t i = 0; i < static_cast<std::size_t>(robot_.n()); ++i)
      aside[i] += kAside * idle(static_cast<Eigen::Index>(i), 0);
    if (!solver_.solve_free(aside, kExactly)) return false;
    return largest_change(to_vector(aside, robot_.n()), to_vector(q, robot_.n())) > 0.1 * kAside;
  }

  // Adds a single solution unless it is known. Returns whether it is one inside the limits.
  bool take_exact(JointArray q) {
    if (is_on_curve(q)) return false;
    const Eigen::VectorXd found = to_vector(q, robot_.n());
    wrap_to_seed(robot_, options_, q);
    const bool inside = !options_.respect_limits || solver_.is_within_limits(q);
    if (known_.size() >= kMostSingle || !is_new(robot_, known_, found, kApart)) return inside;
    known_.push_back(found);
    if (inside) solutions_.push_back(to_vector(q, robot_.n()));
    return inside;
  }

  void leave_out(Eigen::Index row) {
    IkGoal fewer = goal_, other = goal_;
    fewer.weights[row] = 0.0;
    other.weights.setZero();
    other.weights[row] = goal_.weights[row];
    SelfMotions curves(robot_, fewer, options_);
    IkSolver starter(robot_, fewer), gap(robot_, other);
    std::size_t searched = 0;
    for (std::size_t k = 0; k < known_.size(); ++k) {
      curves.follow(to_array(known_[k]));
      search(curves, gap, searched);
    }
    for (int start = 1; start <= kCurveStarts; ++start) {
      JointArray q = halton_start(robot_, start, false);
      if (!starter.solve_free(q, options_.iterations)) continue;
      curves.follow(q);
      search(curves, gap, searched);
    }
  }

  // Where the row that is left out comes close to zero: the iterations from there and from both
  // sides, since two solutions may lie close to each other.
  void search(const SelfMotions& curves, IkSolver& gap, std::size_t& searched) {
    for (; searched < curves.curves().size(); ++searched) {
      const std::vector<JointArray>& curve = curves.curves()[searched];
      std::vector<double> left;
      for (const JointArray& q : curve) {
        const IkError error = gap.error_of(q);
        left.push_back(error.position + error.rotation);
      }
      for (std::size_t k = 0; k < curve.size(); ++k) {
        const bool falls = k == 0 || left[k] <= left[k - 1];
        const bool rises = k + 1 == curve.size() || left[k] <= left[k + 1];
        if (!falls || !rises) continue;
        for (std::size_t at = k > 0 ? k - 1 : k; at <= k + 1 && at < curve.size(); ++at)
          take(curve[at]);
      }
    }
  }

  void take(JointArray q) {
    if (solver_.solve_free(q, options_.iterations)) take_exact(q);
  }

  const Robot& robot_;
  const IkGoal goal_;
  const IkOptions& options_;
  IkSolver solver_;
  std::vector<Eigen::VectorXd>& solutions_;
  std::vector<Eigen::VectorXd> known_;  // also outside the limits
};

}  // namespace

void find_branches(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   std::vector<Eigen::VectorXd>& solutions) {
  if ((goal.weights.array() != 0.0).count() != robot.n()) return;
  BranchSearch(robot, goal, options, solutions).run();
}

bool may_be_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   const Eigen::VectorXd& nearest) {
  const double change = largest_change(nearest, options.seed);
  return idle_directions(robot, goal, to_array(nearest), change / kSafeShare).cols() > 0;
}

}  // namespace armlet
