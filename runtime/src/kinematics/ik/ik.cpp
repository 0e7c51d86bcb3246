#include "armlet/kinematics/ik.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/manipulability.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "ik_branches.hpp"
#include "ik_closed.hpp"
#include "ik_free.hpp"
#include "ik_search.hpp"

namespace armlet {
namespace {

constexpr int kNearestStarts = 32;       // after the first solution
constexpr int kNearStarts = 12;          // around the seed
constexpr int kRedundantStarts = 4;      // of an arm of seven joints with a closed form
constexpr std::size_t kFollowed = 3;     // branches of such an arm
constexpr int kNearestWanted = 16;       // number of distinct solutions
constexpr double kSameChoice = 1e-6;     // rad or m
constexpr double kThere = 1e-9;          // m and rad: as exact as solutions
constexpr double kFar = 1e-3;            // rad or m
constexpr int kKeepStarts = 20;          // to test whether an orientation can be kept
constexpr double kLargestValue = 1e6;    // m or rad, of a goal or a seed
constexpr double kSameRotation = 1e-6;   // rad
constexpr double kPositionWeight = 100;  // weight of position while orientation changes least

// Whether all values are finite, and so small that their rounding is far below the tolerances.
bool is_moderate(const Eigen::Ref<const Eigen::VectorXd>& values) {
  return (values.cwiseAbs().array() <= kLargestValue).all();
}

// The status of an invalid goal or seed, or kOk.
IkStatus check_question(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                        const IkOptions& options) {
  const bool given = options.posture && options.posture->posture == Posture::kNearGiven;
  if (options.seed.size() != robot.n()) return IkStatus::kBadSize;
  if (given && options.posture->q_given.size() != robot.n()) return IkStatus::kBadSize;
  if (given && !is_moderate(options.posture->q_given)) return IkStatus::kNotFinite;
  if (!is_moderate(options.seed) || !is_moderate(T_world_tool.translation()) ||
      !T_world_tool.linear().allFinite())
    return IkStatus::kNotFinite;
  const bool uses_rotation =
      options.task != IkTask::kPosition && options.task != IkTask::kPositionFirst;
  if (uses_rotation && !is_rotation(T_world_tool.linear())) return IkStatus::kBadRotation;
  return IkStatus::kOk;
}

void take_solution(const Robot& robot, const IkGoal& goal, const Eigen::VectorXd& q,
                   IkResult& result) {
  const IkError error = IkSolver(robot, goal).error_of(to_array(q));
  result.status = IkStatus::kOk;
  result.q = q;
  result.margins = limit_margins(robot, q);
  result.position_error = error.position;
  result.rotation_error = error.rotation;
}

void take_branch(const Robot& robot, const IkGoal& goal, const FormulaSolution& solution,
                 IkResult& result) {
  take_solution(robot, goal, to_vector(solution.q, robot.n()), result);
  result.solver = to_text(closed_form(robot).kind());
  result.branch = solution.branch;
}

// Sets the result to the nearest branch of the closed form.
FormulaAnswer formula_into(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                           IkResult& result) {
  if (options.choice != IkChoice::kNearest || robot.n() > 6 ||
      !formula_applies(robot, goal, options))
    return FormulaAnswer::kSilent;
  std::vector<FormulaSolution> solutions;
  const FormulaAnswer answer = solve_by_formula(robot, goal, options, solutions, 0.0, true);
  if (!solutions.empty())
    take_branch(robot, goal, nearest_branch(robot, options.seed, solutions), result);
  return answer;
}

// For an arm of seven joints: the nearest solution of all branches at all arm angles.
bool redundant_into(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                    IkResult& result) {
  if (options.choice != IkChoice::kNearest || robot.n() != 7 ||
      !formula_applies(robot, goal, options))
    return false;
  const auto found = nearest_over_arm_angles(robot, goal, options);
  double change = INFINITY;
  if (!found.empty()) {
    take_branch(robot, goal, found.front(), result);
    change = change_of(found.front().q, options.seed);
  }
  // Near a singularity the arm angle is not a good parameter, so solutions are followed in joint
  // space.
  std::vector<JointArray> starts;
  for (const FormulaSolution& solution : found) {
    if (starts.size() < kFollowed) starts.push_back(solution.q);
  }
  std::vector<Eigen::VectorXd> around;
  search_near(robot, goal, options, kRedundantStarts, around);
  for (const Eigen::VectorXd& q : around) starts.push_back(to_array(q));
  for (JointArray& q : starts) {
    slide_nearer(robot, goal, options, q);
    if (change_of(q, options.seed) >= change - kSameChoice) continue;
    change = change_of(q, options.seed);
    take_solution(robot, goal, to_vector(q, robot.n()), result);
    result.branch = -1;
    result.starts = kRedundantStarts;
    result.solver = IkResult().solver;
  }
  return change < INFINITY;
}

// An arm at the goal does not move; the same holds within kThere of it if the solution is far.
void stay_if_there(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                   IkResult& result) {
  if (options.choice != IkChoice::kNearest || options.posture) return;
  const double change = result.ok() ? largest_change(result.q, options.seed) : INFINITY;
  if (change <= kSameChoice) return;
  if (options.respect_limits && !within_limits(robot, options.seed, 0.0)) return;
  const bool counts_position = (goal.weights.head<3>().array() == 1.0).all();
  const Eigen::Vector3d position = forward(robot, options.seed).translation();
  if (counts_position && (position - goal.p).norm() > 2.0 * goal.position_tolerance + kThere)
    return;
  const IkError error = IkSolver(robot, goal).error_of(to_array(options.seed));
  const double exact = std::max(error.position, error.rotation);
  if (!(exact <= kThere || (change > kFar && goal.is_met(error)))) return;
  take_solution(robot, goal, options.seed, result);
  result.branch = -1;
  result.solver = kStands;
}

// Finds a solution by closed form or by search, and stores the first or the nearest one. Returns
// false if there is none.
bool find_into(const Robot& robot, const IkGoal& goal, const IkOptions& options, IkResult& result) {
  switch (formula_into(robot, goal, options, result)) {
    case FormulaAnswer::kSome:
    case FormulaAnswer::kAll:
      return true;
    case FormulaAnswer::kNone:
      result.q = options.seed;
      result.solver = to_text(closed_form(robot).kind());
      return false;
    case FormulaAnswer::kSilent:
      break;
  }
  if (redundant_into(robot, goal, options, result)) return true;
  const bool nearest = options.choice == IkChoice::kNearest;
  IkSearch search =
      search_ik(robot, goal, options, nearest ? kNearestWanted : 1, nearest ? kNearestStarts : 0);
  result.iterations += search.iterations;
  result.starts += search.starts;
  if (search.solutions.empty()) {
    result.q = search.closest;
    result.position_error = search.closest_error.position;
    result.rotation_error = search.closest_error.rotation;
    return false;
  }
  if (nearest) {
    search_near(robot, goal, options, kNearStarts, search.solutions);
    sort_by_nearness(robot, options.seed, search.solutions);
    if (may_be_nearer(robot, goal, options, search.solutions.front()))
      find_branches(robot, goal, options, search.solutions);
    bring_nearer(robot, goal, options, search.solutions);
  }
  take_solution(robot, goal, search.solutions.front(), result);
  return true;
}

bool search_into(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                 IkResult& result) {
  result.status = IkStatus::kUnreachable;
  if (find_into(robot, goal, options, result)) result.status = IkStatus::kOk;
  stay_if_there(robot, goal, options, result);
  return result.ok();
}

// From q, at which the position is met, the nearby configuration with the smallest rotation of the
// tool.
Eigen::VectorXd rotate_least(const Robot& robot, const IkGoal& keep, const Eigen::VectorXd& q,
                             const IkOptions& options, IkResult& result) {
  IkGoal weighted = keep;
  weighted.weights.head<3>() *= kPositionWeight;
  JointArray joints = to_array(q);
  IkSolver turning(robot, weighted);
  turning.minimise_in_box(joints, 100);
  IkSolver placing(robot, keep.without_orientation());
  const bool placed = placing.solve_in_box(joints, options.iterations);
  result.iterations += turning.iterations_used() + placing.iterations_used();
  return placed ? to_vector(joints, robot.n()) : q;
}

// kPositionFirst when the orientation cannot be kept: of the configurations at that position, the
// one that changes it least. The start at the seed comes first because it changes the joints least.
bool position_into(const Robot& robot, const IkGoal& keep, const IkOptions& options,
                   IkResult& result) {
  const IkGoal position_goal = keep.without_orientation();
  const IkSearch search = search_ik(robot, position_goal, options, kNearestWanted, kNearestStarts);
  result.iterations += search.iterations;
  result.starts += search.starts;
  result.solver = IkResult().solver;
  if (search.solutions.empty()) {
    result.q = search.closest;
    result.position_error = search.closest_error.position;
    result.rotation_error = 0.0;
    return false;
  }
  std::vector<Eigen::VectorXd> candidates = {options.seed};
  candidates.insert(candidates.end(), search.solutions.begin(), search.solutions.end());
  double smallest = INFINITY;
  for (const Eigen::VectorXd& candidate : candidates) {
    const Eigen::VectorXd q = rotate_least(robot, keep, candidate, options, result);
    const IkError error = IkSolver(robot, keep).error_of(to_array(q));
    if (error.position > options.position_tolerance || error.rotation >= smallest - kSameRotation)
      continue;
    smallest = error.rotation;
    take_solution(robot, position_goal, q, result);
  }
  return smallest < INFINITY;
}

// The same for an arm whose closed form gives the few solutions for a position.
FormulaAnswer position_by_formula(const Robot& robot, const IkGoal& keep, const IkOptions& options,
                                  IkResult& result) {
  const IkGoal position_goal = keep.without_orientation();
  if (options.choice != IkChoice::kNearest || options.posture ||
      !closed_form(robot).position_only() || !formula_applies(robot, position_goal, options))
    return FormulaAnswer::kSilent;
  std::vector<FormulaSolution> solutions;
  const FormulaAnswer answer = solve_by_formula(robot, position_goal, options, solutions);
  if (answer == FormulaAnswer::kNone) {
    result.q = options.seed;
    result.solver = to_text(closed_form(robot).kind());
  }
  if (answer != FormulaAnswer::kAll) return answer;
  IkSolver solver(robot, keep);
  const auto error_of = [&](const FormulaSolution& s) { return solver.error_of(s.q).rotation; };
  const double least = error_of(*std::ranges::min_element(solutions, {}, error_of));
  std::erase_if(solutions,
                [&](const FormulaSolution& s) { return error_of(s) > least + kSameRotation; });
  take_branch(robot, position_goal, nearest_branch(robot, options.seed, solutions), result);
  return answer;
}

// kPositionFirst: with the orientation of the goal if the arm can keep it.
bool solve_position(const Robot& robot, const Eigen::Isometry3d& T_world_tool, const IkGoal& keep,
                    const IkOptions& options, IkResult& result) {
  switch (position_by_formula(robot, keep, options, result)) {
    case FormulaAnswer::kAll:
      return true;
    case FormulaAnswer::kNone:
      return false;
    default:
      break;
  }
  IkOptions first = options;
  first.starts = std::min(options.starts, kKeepStarts);
  if (!search_into(robot, keep, first, result)) return position_into(robot, keep, options, result);
  if (options.posture) take_best_posture(robot, T_world_tool, keep, options, result);
  return true;
}

}  // namespace

IkGoal make_goal(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                 const IkOptions& options) {
  IkGoal goal;
  goal.p = T_world_tool.translation();
  goal.R = T_world_tool.linear();
  goal.position_tolerance = options.position_tolerance;
  goal.rotation_tolerance = options.rotation_tolerance;
  switch (options.task) {
    case IkTask::kPose:
      break;
    case IkTask::kPosition:
      goal.weights.tail<3>().setZero();
      break;
    case IkTask::kPositionFirst:
      goal.R = forward(robot, options.seed).linear();
      break;
    case IkTask::kHeading:
      goal.R = with_heading_of(robot, T_world_tool, options.seed).linear();
      break;
    case IkTask::kMasked:
      for (std::size_t i = 0; i < 6; ++i) {
        goal.weights[static_cast<Eigen::Index>(i)] = options.mask[i] ? 1.0 : 0.0;
      }
      goal.in_tool_axes = options.mask_frame == IkMaskFrame::kTool;
      break;
  }
  return goal;
}

std::string_view to_text(IkStatus status) {
  switch (status) {
    case IkStatus::kOk:
      return "ok";
    case IkStatus::kUnreachable:
      return "unreachable";
    case IkStatus::kOrientationUnreachable:
      return "orientation unreachable";
    case IkStatus::kJointLimit:
      return "joint limit";
    case IkStatus::kSingularGoal:
      return "singular goal";
    case IkStatus::kBadRotation:
      return "bad rotation";
    case IkStatus::kBadSize:
      return "bad size";
    case IkStatus::kNotFinite:
      return "not finite";
  }
  return "unknown";
}

namespace {

// Solves with a given seed.
IkResult solve_from_seed(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                         const IkOptions& options) {
  IkResult result;
  result.status = check_question(robot, T_world_tool, options);
  if (result.status != IkStatus::kOk) {
    result.q = robot.home();
    return result;
  }

  IkGoal goal = make_goal(robot, T_world_tool, options);
  if (options.task == IkTask::kPositionFirst) {
    if (solve_position(robot, T_world_tool, goal, options, result)) return result;
    goal = goal.without_orientation();
  } else if (search_into(robot, goal, options, result)) {
    if (options.posture) take_best_posture(robot, T_world_tool, goal, options, result);
    return result;
  }
  result.status = IkStatus::kUnreachable;
  if (result.q.size() == 0) result.q = robot.home();
  if (options.diagnose && diagnose(robot, goal, options, result)) {
    take_solution(robot, goal, result.diagnosis.q_nearest, result);
    result.solver = IkResult().solver;
    result.diagnosis = {};
  }
  return result;
}

}  // namespace

IkResult solve_ik(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                  const IkOptions& options) {
  if (options.seed.size() > 0) return solve_from_seed(robot, T_world_tool, options);
  IkOptions from_home = options;
  from_home.seed = robot.home();
  return solve_from_seed(robot, T_world_tool, from_home);
}

namespace {

std::vector<Eigen::VectorXd> all_solutions(const Robot& robot, const IkGoal& goal,
                                           const IkOptions& options, int count) {
  if (formula_applies(robot, goal, options)) {
    std::vector<FormulaSolution> branches;
    FormulaAnswer answer = solve_by_formula(robot, goal, options, branches);
    if (branches.empty() && robot.n() == 7) {
      branches = solve_over_arm_angles(robot, goal, options);
      if (!branches.empty()) answer = FormulaAnswer::kSome;
    }
    if (answer != FormulaAnswer::kSilent) {
      std::vector<Eigen::VectorXd> all;
      for (const FormulaSolution& branch : branches) all.push_back(to_vector(branch.q, robot.n()));
      sort_by_nearness(robot, options.seed, all);
      if (static_cast<int>(all.size()) > count)
        all.resize(static_cast<std::size_t>(std::max(count, 0)));
      return all;
    }
  }
  IkSearch search = search_ik(robot, goal, options, count, options.starts);
  find_branches(robot, goal, options, search.solutions);
  sort_by_nearness(robot, options.seed, search.solutions);
  if (static_cast<int>(search.solutions.size()) > count)
    search.solutions.resize(static_cast<std::size_t>(std::max(count, 0)));
  return search.solutions;
}

}  // namespace

std::vector<Eigen::VectorXd> solve_ik_all(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                                          const IkOptions& given, int count) {
  IkOptions options = given;
  if (options.seed.size() == 0) options.seed = robot.home();
  if (check_question(robot, T_world_tool, options) != IkStatus::kOk) return {};
  IkGoal goal = make_goal(robot, T_world_tool, options);
  const bool position_first = options.task == IkTask::kPositionFirst;
  if (position_first && closed_form(robot).position_only()) goal = goal.without_orientation();
  std::vector<Eigen::VectorXd> all = all_solutions(robot, goal, options, count);
  if (!all.empty() || !position_first) return all;
  // The orientation cannot be kept: all solutions with the orientation that is nearest to it.
  options.diagnose = false;
  const IkResult turned = solve_ik(robot, T_world_tool, options);
  if (!turned.ok()) return {};
  goal.R = forward(robot, turned.q).linear();
  return all_solutions(robot, goal, options, count);
}

std::string branch_name(const Robot& robot, const IkResult& result) {
  return result.branch < 0 ? std::string() : closed_form(robot).branch_name(result.branch);
}

std::string explain(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                    const IkResult& result) {
  const IkDiagnosis& d = result.diagnosis;
  std::string text;
  switch (result.status) {
    case IkStatus::kOk:
      return "The pose is reached.";
    case IkStatus::kBadRotation:
      return "The goal's 3x3 part is not a rotation.";
    case IkStatus::kBadSize:
      return fmt::format("The seed must have {} joint values.", robot.n());
    case IkStatus::kNotFinite:
      return "The goal or the seed contains a value that is not a finite number up to 1e6 m or "
             "rad.";
    case IkStatus::kJointLimit:
      text = "The pose can be reached only outside the limits: ";
      for (std::size_t i = 0; i < d.violations.size(); ++i) {
        text += (i > 0 ? "; " : "") + describe(robot, d.violations[i]);
      }
      break;
    case IkStatus::kUnreachable:
      text = fmt::format("The point {} is out of reach by {}; the nearest reachable point is {}",
                         format_point_mm(T_world_tool.translation()), format_mm(d.distance),
                         format_point_mm(d.nearest.translation()));
      break;
    case IkStatus::kOrientationUnreachable:
      text = fmt::format(
          "The place can be reached, but not with this orientation; the closest one differs by {}",
          format_deg(d.angle));
      break;
    case IkStatus::kSingularGoal:
      text = "The arm is singular at the goal and cannot settle there";
      break;
  }
  if (d.gap.exists()) text += "; " + describe(d.gap);
  if (d.sigma_min < 1e-3 && result.status != IkStatus::kJointLimit) {
    Singularity lost;
    lost.direction = d.lost_direction;
    text += "; the arm is singular there: it " + describe(lost);
  }
  return text + ".";
}

}  // namespace armlet
