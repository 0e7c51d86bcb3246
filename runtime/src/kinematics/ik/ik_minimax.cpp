#include "ik_minimax.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "ik_free.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kLpVariables = static_cast<std::size_t>(kMostIdle) + 1;
constexpr double kLpBox = 1e3;        // rad or m, bound on all variables
constexpr double kLpExact = 1e-12;    // rad or m
constexpr double kFirstRadius = 0.3;  // rad or m
constexpr double kLastRadius = 1e-7;
constexpr double kNoGain = 1e-9;
constexpr int kMinimaxSteps = 60;
constexpr int kBackToGoal = 8;

using Variables = std::array<double, kLpVariables>;

// The half space a x <= b.
struct Half {
  Variables a{};
  double b = 0.0;
};

double dot(const Variables& a, const Variables& x, std::size_t d) {
  double sum = 0.0;
  for (std::size_t k = 0; k < d; ++k) sum += a[k] * x[k];
  return sum;
}

std::optional<Variables> least_of_one(std::span<const Half> halves, double c) {
  double low = -kLpBox, high = kLpBox;
  for (const Half& half : halves) {
    const double a = half.a[0];
    if (a > kLpExact) {
      high = std::min(high, half.b / a);
    } else if (a < -kLpExact) {
      low = std::max(low, half.b / a);
    } else if (half.b < -kLpExact) {
      return std::nullopt;
    }
  }
  if (low > high + kLpExact) return std::nullopt;
  if (c == 0.0) return Variables{std::clamp(0.0, std::min(low, high), high)};
  return Variables{c > 0.0 ? low : high};
}

// Eliminates variable p, which follows from the others on the plane of `on`.
Half without_variable(const Half& half, const Half& on, std::size_t p, std::size_t d) {
  Half out;
  const double share = half.a[p] / on.a[p];
  for (std::size_t k = 0, to = 0; k < d; ++k) {
    if (k != p) out.a[to++] = half.a[k] - share * on.a[k];
  }
  out.b = half.b - share * on.b;
  return out;
}

// The point of least c x within all half spaces of the first d variables; nothing if there is none.
// If the minimum so far violates the next half space, the new minimum is on its plane.
std::optional<Variables> least_point(std::span<const Half> halves, const Variables& c,
                                     std::size_t d) {
  if (d == 1) return least_of_one(halves, c[0]);
  Variables x{};
  for (std::size_t k = 0; k < d; ++k) x[k] = c[k] > 0.0 ? -kLpBox : c[k] < 0.0 ? kLpBox : 0.0;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const Half& on = halves[i];
    if (dot(on.a, x, d) <= on.b + kLpExact) continue;
    const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto p = static_cast<std::size_t>(
        std::max_element(on.a.begin(), on.a.begin() + static_cast<std::ptrdiff_t>(d), larger) -
        on.a.begin());
    if (std::abs(on.a[p]) < kLpExact) return std::nullopt;
    std::vector<Half> before;
    for (std::size_t j = 0; j < i; ++j) before.push_back(without_variable(halves[j], on, p, d));
    const Half cost = without_variable({c, 0.0}, on, p, d);
    const auto rest = least_point(before, cost.a, d - 1);
    if (!rest) return std::nullopt;
    double sum = on.b;
    for (std::size_t k = 0, from = 0; k < d; ++k) {
      if (k == p) continue;
      x[k] = (*rest)[from++];
      sum -= on.a[k] * x[k];
    }
    x[p] = sum / on.a[p];
  }
  return x;
}

// The joint changes of a step, and the resulting largest change from the seed.
struct Step {
  VectorXd dq;
  double change = INFINITY;
};

std::optional<Step> minimax_step(const Robot& robot, const IkOptions& options, const JointArray& q,
                                 const JointDirections& idle, double radius) {
  const auto m = static_cast<std::size_t>(idle.cols());
  std::vector<Half> halves;
  // The variables are the coefficients of the directions, followed by the largest change.
  const auto add = [&](Eigen::Index joint, double sign, double of_change, double b) {
    Half half{.b = b};
    for (std::size_t k = 0; k < m; ++k)
      half.a[k] = sign * idle(joint, static_cast<Eigen::Index>(k));
    half.a[m] = of_change;
    halves.push_back(half);
  };
  for (std::size_t k = 0; k < m; ++k) {
    for (const double sign : {1.0, -1.0}) {
      halves.push_back({.b = radius});
      halves.back().a[k] = sign;
    }
  }
  for (Eigen::Index i = 0; i < robot.n(); ++i) {
    const double value = q[static_cast<std::size_t>(i)], away = value - options.seed[i];
    add(i, 1.0, -1.0, -away);
    add(i, -1.0, -1.0, away);
    if (!options.respect_limits) continue;
    add(i, 1.0, 0.0, std::max(robot.upper()[i] - value, 0.0));
    add(i, -1.0, 0.0, std::max(value - robot.lower()[i], 0.0));
  }
  Variables cost{};
  cost[m] = 1.0;
  const auto x = least_point(halves, cost, m + 1);
  if (!x) return std::nullopt;
  const Eigen::Map<const VectorXd> parts(x->data(), idle.cols());
  return Step{idle * parts, (*x)[m]};
}

}  // namespace

void slide_minimax(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q,
                   double singular) {
  IkSolver solver(robot, goal);
  double change = change_of(q, options.seed), radius = kFirstRadius;
  for (int k = 0; k < kMinimaxSteps && radius > kLastRadius; ++k) {
    const JointDirections idle = idle_directions(robot, goal, q, singular);
    if (idle.cols() == 0 || idle.cols() > kMostIdle) return;
    const auto step = minimax_step(robot, options, q, idle, radius);
    if (!step || change - step->change < kNoGain) return;
    JointArray next = q;
    for (Eigen::Index i = 0; i < step->dq.size(); ++i)
      next[static_cast<std::size_t>(i)] += step->dq[i];
    const bool met = options.respect_limits ? solver.solve_in_box(next, kBackToGoal)
                                            : solver.solve_free(next, kBackToGoal);
    const double reached = met && goal.is_met(solver.error_of(next))
                               ? change_of(next, options.seed)
                               : std::numeric_limits<double>::infinity();
    const double share = (change - reached) / (change - step->change);
    if (share < 0.25) radius *= 0.5;
    if (share > 0.7) radius = std::min(2.0 * radius, kFirstRadius);
    if (!(reached < change)) continue;
    q = next;
    change = reached;
  }
}

}  // namespace armlet
