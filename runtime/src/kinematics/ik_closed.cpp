#include "ik_closed.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

constexpr int kArmAngles = 36;  // of a turn, tried for an arm of seven joints
constexpr double kArmStep = 2.0 * kPi / kArmAngles;
constexpr int kArmHalvings = 8;      // of the step, around the best of them
constexpr std::size_t kValleys = 3;  // that are looked at more closely

// How far a joint may lie beyond its limit by rounding, next to a singularity; it is put back and
// the goal checked again.
constexpr double kRounding = 1e-6;

// Next to a singularity, joints that are exact enough for a place may turn the tool so far from the
// goal, rad, and are improved.
constexpr double kNearlyTurned = 0.1;

bool counts_all(const IkGoal& goal) { return (goal.weights.array() == 1.0).all(); }
bool counts_place(const IkGoal& goal) {
  return (goal.weights.head<3>().array() == 1.0).all() && goal.weights.tail<3>().isZero();
}

// Turns the joints to the copies nearest to the seed. False if one lies beyond its limits.
bool bring_within(const Robot& robot, const IkOptions& options, JointArray& q, bool& moved) {
  moved = false;
  for (int i = 0; i < robot.n(); ++i) {
    double& value = q[static_cast<std::size_t>(i)];
    const double near = options.seed[i];
    if (!options.respect_limits) {
      if (robot.is_revolute(i) && std::abs(value - near) > kPi) value = nearest_turn(value, near);
      continue;
    }
    const double lower = robot.lower()[i];
    const double upper = robot.upper()[i];
    if (robot.is_revolute(i))
      value = turned_within(value, near, lower - kRounding, upper + kRounding);
    if (value >= lower && value <= upper) continue;
    if (!(value >= lower - kRounding && value <= upper + kRounding)) return false;
    value = std::clamp(value, lower, upper);
    moved = true;
  }
  return true;
}

}  // namespace

bool formula_applies(const Robot& robot, const IkGoal& goal, const IkOptions& options) {
  if (options.method != IkMethod::kAuto) return false;
  const ClosedForm& closed = closed_form(robot);
  if (!closed.exists()) return false;
  return counts_all(goal) || (closed.place_only() && counts_place(goal));
}

FormulaAnswer solve_by_formula(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                               std::vector<FormulaSolution>& solutions, double arm_turn) {
  const ClosedForm& closed = closed_form(robot);
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() = goal.R;
  T_world_tool.translation() = goal.p;
  ClosedSolutions found;
  closed.solve(T_world_tool, options.seed, found,
               std::min(goal.position_tolerance, goal.rotation_tolerance), arm_turn);
  const bool check_turn = closed.place_only() && counts_all(goal);
  for (const ClosedSolution& solution : found) {
    FormulaSolution candidate{solution.q, solution.branch};
    bool moved = false;
    if (!bring_within(robot, options, candidate.q, moved)) continue;
    if (moved || check_turn) {
      IkSolver solver(robot, goal);
      const IkError error = solver.error_of(candidate.q);
      if (!goal.is_met(error) &&
          !(error.rotation < kNearlyTurned && solver.solve_in_box(candidate.q, options.iterations)))
        continue;
    }
    solutions.push_back(candidate);
  }
  const bool all = closed.complete() && !found.free;
  if (solutions.empty()) return all ? FormulaAnswer::kNone : FormulaAnswer::kSilent;
  return all ? FormulaAnswer::kAll : FormulaAnswer::kSome;
}

std::vector<FormulaSolution> solve_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                   const IkOptions& options) {
  std::vector<FormulaSolution> solutions;
  for (int k = 0; k < kArmAngles && solutions.empty(); ++k) {
    // 0, +1, -1, +2, -2, ... steps
    const int step = k % 2 == 1 ? (k + 1) / 2 : -k / 2;
    solve_by_formula(robot, goal, options, solutions, step * kArmStep);
  }
  return solutions;
}

namespace {

// The solution that is reached soonest at one arm angle.
struct AtAngle {
  double angle = 0.0;
  double time = INFINITY;  // s
  FormulaSolution solution;
};

AtAngle soonest_at(const Robot& robot, const IkGoal& goal, const IkOptions& options, double angle) {
  std::vector<FormulaSolution> solutions;
  solve_by_formula(robot, goal, options, solutions, angle);
  AtAngle out{.angle = angle};
  for (const FormulaSolution& solution : solutions) {
    const double time = least_way_time(robot, to_vector(solution.q, robot.n()), options.seed);
    if (time < out.time) {
      out.time = time;
      out.solution = solution;
    }
  }
  return out;
}

}  // namespace

std::optional<FormulaSolution> soonest_over_arm_angles(const Robot& robot, const IkGoal& goal,
                                                       const IkOptions& options) {
  std::vector<AtAngle> tried;
  for (int k = 0; k < kArmAngles; ++k)
    tried.push_back(soonest_at(robot, goal, options, k * kArmStep));
  // The time is not convex in the arm angle: the best few valleys are followed down.
  std::vector<AtAngle> valleys;
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const double before = tried[(k + tried.size() - 1) % tried.size()].time;
    const double after = tried[(k + 1) % tried.size()].time;
    if (tried[k].time <= before && tried[k].time <= after && tried[k].time < INFINITY)
      valleys.push_back(tried[k]);
  }
  const auto sooner = [](const AtAngle& a, const AtAngle& b) { return a.time < b.time; };
  std::ranges::stable_sort(valleys, sooner);
  if (valleys.size() > kValleys) valleys.resize(kValleys);
  AtAngle best;
  for (AtAngle& valley : valleys) {
    double step = kArmStep;
    for (int k = 0; k < kArmHalvings; ++k) {
      step *= 0.5;
      const double middle = valley.angle;
      for (const double angle : {middle + step, middle - step})
        valley = std::min(valley, soonest_at(robot, goal, options, angle), sooner);
    }
    best = std::min(best, valley, sooner);
  }
  if (best.time == INFINITY) return std::nullopt;
  return best.solution;
}

}  // namespace armlet
