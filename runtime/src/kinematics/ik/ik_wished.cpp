#include "ik_wished.hpp"

#include <algorithm>
#include <cmath>

#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kWidestStep = 0.5;  // rad or m
constexpr double kNarrowestStep = 1e-7;
constexpr int kWishedSteps = 60;
constexpr int kBackToSolutions = 8;      // iterations
constexpr double kRegularised = 1e-12;   // of the largest diagonal element
constexpr double kSmallestGain = 1e-10;  // of the cost

// The step from q to the point that is nearest to the desired values among those that meet the
// linearised goal within the limits. While joints would leave their limits, the one that would be
// farthest beyond, in ranges, is set to its limit and the step is computed again.
VectorXd step_to_wished(const Robot& robot, const IkRows& rows, const WishedJoints& wished,
                        const VectorXd& q) {
  const Eigen::Index n = q.size();
  VectorXd dq = wished.q - q, spread = wished.range.cwiseAbs2();
  VectorXd aim = (spread.array() > 0.0).select(dq, 0.0);  // for a joint on its limit: to that limit
  for (Eigen::Index held = 0; held <= n; ++held) {
    const Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints> JS =
        rows.J * spread.asDiagonal();
    Eigen::Matrix<double, 6, 6> A = JS * rows.J.transpose();
    A.diagonal().array() += kRegularised * A.diagonal().maxCoeff() + 1e-300;
    dq = aim + JS.transpose() * SymmetricFactors<6>(A).solve(rows.error - rows.J * aim);
    Eigen::Index worst = -1;
    double beyond = 1e-12;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (spread[i] == 0.0) continue;
      const double to = q[i] + dq[i];
      const double off = std::max(to - robot.upper()[i], robot.lower()[i] - to) / wished.range[i];
      if (off <= beyond) continue;
      beyond = off;
      worst = i;
    }
    if (worst < 0) break;
    const double limit =
        q[worst] + dq[worst] > robot.upper()[worst] ? robot.upper()[worst] : robot.lower()[worst];
    aim[worst] = limit - q[worst];
    spread[worst] = 0.0;
  }
  return dq;
}

}  // namespace

double WishedJoints::cost(const JointArray& at) const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (!(range[i] > 0.0)) continue;
    const double off = (at[static_cast<std::size_t>(i)] - q[i]) / range[i];
    sum += off * off;
  }
  return 0.5 * sum;
}

void slide_to_wished(const Robot& robot, IkSolver& solver, const WishedJoints& wished,
                     JointArray& q) {
  double cost = wished.cost(q), widest = kWidestStep;
  bool has_moved = true;
  VectorXd step;
  for (int k = 0; k < kWishedSteps && widest > kNarrowestStep; ++k) {
    if (has_moved) step = step_to_wished(robot, solver.rows_of(q), wished, to_vector(q, robot.n()));
    const double largest = step.cwiseAbs().maxCoeff();
    if (!(largest > kNarrowestStep)) return;
    const double share = std::min(1.0, widest / largest);
    JointArray next = q;
    for (Eigen::Index i = 0; i < step.size(); ++i)
      next[static_cast<std::size_t>(i)] += share * step[i];
    const double reached =
        solver.solve_in_box(next, kBackToSolutions) ? wished.cost(next) : INFINITY;
    has_moved = reached < cost;
    if (!has_moved) {
      widest = 0.3 * std::min(widest, largest);
      continue;
    }
    const double gain = cost - reached;
    q = next;
    cost = reached;
    if (gain < kSmallestGain * cost) return;
    widest = std::min(2.0 * widest, kWidestStep);
  }
}

}  // namespace armlet
