#include "ik_search.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

#include "armlet/math/angles.hpp"
#include "kinematics/forward/periodic.hpp"

namespace armlet {
namespace {

constexpr double kRotationRounding = 1e-9;  // rad
constexpr double kAround = 0.6;             // rad or m, range of starts around the seed
constexpr int kFreeStarts = 8;  // of a search for one solution, without a second try each
constexpr IkPace kFast{.largest_step = 2.0, .progress = 0.9, .stall = 5};

// One start: first without limits, because joints held at their limits would block the iteration;
// if the result is outside, then from the nearest configuration inside.
//
// only_free  another start is tried instead. For a goal with isolated solutions, a solution outside
//            the limits rarely leads to one inside.
bool solve_from(const Robot& robot, IkSolver& solver, JointArray& q, const IkOptions& options,
                bool only_free) {
  if (!options.respect_limits) return solver.solve_free(q, options.iterations);
  const JointArray start = q;
  if (solver.solve_free(q, options.iterations)) {
    wrap_to_seed(robot, options, q);
    if (solver.is_within_limits(q)) return true;
    if (only_free) return false;
    return solver.solve_in_box(q, options.iterations);
  }
  if (only_free) return false;
  q = start;
  return solver.solve_in_box(q, options.iterations);
}

// Position and rotation errors on one scale.
double badness(const Robot& robot, const IkError& error) {
  return error.position / robot.length() + error.rotation;
}

// The joint that folds the arm: the second if axes 1 and 2 are parallel, else the third.
int elbow_of(const Robot& robot) {
  const double twist = robot.chain().sin_alpha[1];
  return std::min(robot.n() - 1, std::abs(twist) < 1e-9 ? 1 : 2);
}

}  // namespace

double largest_change(const Eigen::VectorXd& q_1, const Eigen::VectorXd& q_2) {
  return (q_1 - q_2).cwiseAbs().maxCoeff();
}

bool is_new(const Robot& robot, const std::vector<Eigen::VectorXd>& solutions,
            const Eigen::VectorXd& q, double same) {
  return std::none_of(solutions.begin(), solutions.end(), [&](const Eigen::VectorXd& other) {
    for (int i = 0; i < robot.n(); ++i) {
      const double change =
          is_periodic(robot, i) ? angle_difference(q[i], other[i]) : q[i] - other[i];
      if (std::abs(change) > same) return false;
    }
    return true;
  });
}

void wrap_to_seed(const Robot& robot, const IkOptions& options, JointArray& q, double beyond) {
  for (int i = 0; i < robot.n(); ++i) {
    if (!is_periodic(robot, i)) continue;
    double& value = q[static_cast<std::size_t>(i)];
    if (!options.respect_limits) {
      value = nearest_copy_of_angle(value, options.seed[i]);
      continue;
    }
    const double lower = robot.lower()[i], upper = robot.upper()[i];
    value = wrapped_within(value, options.seed[i], lower - beyond, upper + beyond);
    const double inside = std::clamp(value, lower, upper);
    if (std::abs(value - inside) < kRotationRounding) value = inside;
  }
}

IkSearch search_ik(const Robot& robot, const IkGoal& goal, const IkOptions& options, int wanted,
                   int extra_starts) {
  const bool one = wanted == 1;
  const bool single_solutions = (goal.weights.array() != 0.0).count() >= robot.n();
  IkSolver solver(robot, goal, one ? kFast : IkPace());
  IkSearch search;
  double best = INFINITY;
  int last_start = options.starts;
  for (int start = 0; start < last_start; ++start) {
    JointArray q =
        start == 0 ? to_array(options.seed) : halton_start(robot, start, options.respect_limits);
    const bool found =
        solve_from(robot, solver, q, options, one && single_solutions && start < kFreeStarts);
    ++search.starts;
    if (found) {
      wrap_to_seed(robot, options, q);
      Eigen::VectorXd candidate = to_vector(q, robot.n());
      if (search.solutions.empty()) last_start = std::min(last_start, start + 1 + extra_starts);
      if (is_new(robot, search.solutions, candidate))
        search.solutions.push_back(std::move(candidate));
      if (static_cast<int>(search.solutions.size()) >= wanted) break;
      continue;
    }
    const IkError error = solver.error_of(q);
    if (badness(robot, error) < best) {
      best = badness(robot, error);
      search.closest = to_vector(q, robot.n());
      search.closest_error = error;
    }
  }
  search.iterations = solver.iterations_used();
  return search;
}

void search_near(const Robot& robot, const IkGoal& goal, const IkOptions& options, int starts,
                 std::vector<Eigen::VectorXd>& solutions) {
  if (!options.respect_limits) return;
  IkSolver solver(robot, goal);
  for (int start = 0; start < starts; ++start) {
    JointArray q = to_array(options.seed);
    for (int i = 0; start > 0 && i < robot.n(); ++i) {
      const double range = robot.upper()[i] - robot.lower()[i];
      q[static_cast<std::size_t>(i)] +=
          kAround * std::min(range, 1.0) * (halton_share(i, start) - 0.5);
    }
    if (solver.solve_in_box(q, options.iterations)) solutions.push_back(to_vector(q, robot.n()));
  }
}

namespace {

// Order of solutions by their distance from the seed. Rounding to a grid instead of a tolerance
// keeps it transitive.
struct Nearness {
  double change = 0.0;
  bool bent_down = false;  // the elbow is not positive

  Nearness(const Robot& robot, const Eigen::VectorXd& seed, const double* q) {
    for (int i = 0; i < robot.n(); ++i) change = std::max(change, std::abs(q[i] - seed[i]));
    change = std::round(change * 1e9);
    bent_down = q[elbow_of(robot)] <= 0.0;
  }
  auto operator<=>(const Nearness&) const = default;
};

}  // namespace

void sort_by_nearness(const Robot& robot, const Eigen::VectorXd& seed,
                      std::vector<Eigen::VectorXd>& solutions) {
  std::ranges::stable_sort(solutions, [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return Nearness(robot, seed, a.data()) < Nearness(robot, seed, b.data());
  });
}

const FormulaSolution& nearest_branch(const Robot& robot, const Eigen::VectorXd& seed,
                                      const std::vector<FormulaSolution>& branches) {
  return *std::min_element(
      branches.begin(), branches.end(), [&](const FormulaSolution& a, const FormulaSolution& b) {
        return Nearness(robot, seed, a.q.data()) < Nearness(robot, seed, b.q.data());
      });
}

}  // namespace armlet
