#include "ik_branches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/math/angles.hpp"
#include "kinematics/forward/periodic.hpp"
#include "kinematics/self_motion/self_motion.hpp"
#include "near_singular/ik_reduced.hpp"

namespace armlet {
namespace {

constexpr int kCurveStarts = 6;   // for each row that is left out
constexpr double kExact = 1e-12;  // m and rad
constexpr int kExactly = 100;     // iterations
constexpr double kApart = 1e-6;   // rad or m; solutions that are closer are one
constexpr double kBeside = 3e-3;  // rad or m from a curve
// The largest number of isolated solutions (D. Manocha, J. F. Canny, Efficient inverse kinematics
// for general 6R manipulators, 1994).
constexpr std::size_t kMostSingle = 16;
constexpr double kAside = 0.02;  // rad or m
constexpr int kRowSamples = 5;
constexpr double kConstant = 1e-12;  // m or rad per rad or m
constexpr double kSafeShare = 0.5;   // of the smallest singular value; bound on a change

class BranchSearch {
 public:
  BranchSearch(const Robot& robot, const IkGoal& goal, const IkOptions& options,
               std::vector<Eigen::VectorXd>& solutions)
      : robot_(robot),
        goal_(exactly(goal)),
        options_(options),
        solver_(robot, goal_),
        loosely_(robot, goal),
        solutions_(solutions) {}

  void run() {
    const std::size_t given = solutions_.size();
    std::vector<Eigen::VectorXd> others;  // solutions on whole curves, and approximate ones
    for (const Eigen::VectorXd& solution : std::exchange(solutions_, {})) {
      if (!take(to_array(solution))) others.push_back(solution);
    }
    for (Eigen::Index row = 0; row < 6; ++row) {
      if (goal_.weights[row] != 0.0) leave_out(row);
    }
    for (const Eigen::VectorXd& solution : others) {
      if (solutions_.size() >= given || !is_new(robot_, solutions_, solution)) continue;
      Reduced* curve = curve_along(to_array(solution));
      if (curve == nullptr || !curve->is_listed) solutions_.push_back(solution);
      if (curve != nullptr) curve->is_listed = true;
    }
  }

 private:
  // A curve near singularities, and whether one of its solutions, or an approximate one, is listed.
  struct Reduced {
    ReducedCurve curve;
    bool is_listed;
  };

  // The goal with tight tolerances: near a singularity many configurations meet the usual ones.
  static IkGoal exactly(IkGoal goal) {
    goal.position_tolerance = goal.rotation_tolerance = kExact;
    return goal;
  }

  // Whether the goal is met along a whole direction. This is also true near two solutions that
  // nearly coincide, but there the iterations lead back to them.
  bool is_on_curve(const JointArray& q) {
    const JointDirections idle = idle_directions(robot_, goal_, q, kIdleTool);
    if (idle.cols() == 0) return false;
    JointArray aside = q;
    for (std::size_t i = 0; i < static_cast<std::size_t>(robot_.n()); ++i)
      aside[i] += kAside * idle(static_cast<Eigen::Index>(i), 0);
    if (!solver_.solve_free(aside, kExactly)) return false;
    return largest_change(to_vector(aside, robot_.n()), to_vector(q, robot_.n())) > 0.1 * kAside;
  }

  // Adds the solutions that the iterations reach from q. Returns whether one is inside the limits.
  bool take(JointArray q) {
    const bool met = solver_.solve_free(q, kExactly);
    if (!met && !loosely_.solve_free(q, kExactly)) return false;
    if (const Reduced* known = curve_along(q)) return known->is_listed;
    if (auto curve = reduced_curve(robot_, goal_, q); curve && !curve->is_idle) {
      bool inside = false;
      for (const JointArray& solution : curve->solutions) inside = take_exact(solution) || inside;
      if (met && is_new(robot_, known_, to_vector(q, robot_.n()), kBeside))
        inside = take_exact(q) || inside;
      reduced_.push_back({std::move(*curve), inside});
      return inside;
    }
    return met && !is_on_curve(q) && take_exact(q);
  }

  // The curve through q: near a singular position the iterations lead to many points of one curve.
  Reduced* curve_along(const JointArray& q) {
    const auto along = [&](const Reduced& known) { return is_along(known.curve.points, q); };
    const auto found = std::ranges::find_if(reduced_, along);
    return found == reduced_.end() ? nullptr : &*found;
  }

  bool is_along(const std::vector<JointArray>& curve, const JointArray& q) const {
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      double across = 0.0, square = 0.0, away = 0.0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(robot_.n()); ++i) {
        double off = q[i] - curve[k][i];
        if (is_periodic(robot_, static_cast<int>(i))) off = wrap_angle(off);
        const double step = curve[k + 1][i] - curve[k][i];
        across += off * step;
        square += step * step;
        away += off * off;
      }
      const double share = std::clamp(across / square, 0.0, 1.0);
      if (away - share * (2.0 * across - share * square) < kBeside * kBeside) return true;
    }
    return false;
  }

  // Adds a solution unless it is known. Returns whether it is inside the limits.
  bool take_exact(JointArray q) {
    const Eigen::VectorXd found = to_vector(q, robot_.n());
    const bool inside = bring_inside(q);
    if (known_.size() >= kMostSingle || !is_new(robot_, known_, found, kApart)) return inside;
    known_.push_back(found);
    if (inside) solutions_.push_back(to_vector(q, robot_.n()));
    return inside;
  }

  // A joint at its limit may exceed it by the uncertainty of the others near a singularity.
  bool bring_inside(JointArray& q) {
    JointArray near = q;
    wrap_to_seed(robot_, options_, near, kApart);
    if (!options_.respect_limits || solver_.is_within_limits(near)) {
      q = near;
      return true;
    }
    JointArray inside = near;
    if (loosely_.solve_in_box(inside, kExactly) &&
        largest_change(to_vector(inside, robot_.n()), to_vector(near, robot_.n())) < kApart) {
      q = inside;
      return true;
    }
    wrap_to_seed(robot_, options_, q);
    return solver_.is_within_limits(q);
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

  // Points where the left-out row is nearly zero: iterations start from there and from both sides,
  // since two solutions may be close to each other.
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

  const Robot& robot_;
  const IkGoal goal_;
  const IkOptions& options_;
  IkSolver solver_, loosely_;  // with the tolerances of the goal
  std::vector<Eigen::VectorXd>& solutions_;
  std::vector<Eigen::VectorXd> known_;  // also outside the limits
  std::vector<Reduced> reduced_{};
};

}  // namespace

namespace {

// The goal without the rows that no joint changes, such as height and tilt of the tool of a planar
// arm. These rows are satisfied at every solution.
IkGoal without_constant_rows(const Robot& robot, IkGoal goal) {
  Vector6d changes = Vector6d::Zero();
  IkSolver solver(robot, goal);
  for (int k = 1; k <= kRowSamples; ++k) {
    const IkRows rows = solver.rows_of(halton_start(robot, k, false));
    changes = changes.cwiseMax(rows.J.cwiseAbs().rowwise().maxCoeff());
  }
  for (Eigen::Index row = 0; row < 6; ++row) {
    if (changes[row] < kConstant) goal.weights[row] = 0.0;
  }
  return goal;
}

}  // namespace

void find_branches(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   std::vector<Eigen::VectorXd>& solutions) {
  const auto rows_of = [](const IkGoal& g) { return (g.weights.array() != 0.0).count(); };
  if (rows_of(goal) == robot.n()) return BranchSearch(robot, goal, options, solutions).run();
  if (rows_of(goal) < robot.n() || solutions.empty()) return;
  const IkGoal fewer = without_constant_rows(robot, goal);
  if (rows_of(fewer) == robot.n()) BranchSearch(robot, fewer, options, solutions).run();
}

bool may_be_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   const Eigen::VectorXd& nearest) {
  const double change = largest_change(nearest, options.seed);
  return idle_directions(robot, goal, to_array(nearest), change / kSafeShare).cols() > 0;
}

}  // namespace armlet
