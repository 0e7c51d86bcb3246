#include "trajectory/velocity/velocity_rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/kinematics/jacobian.hpp"
#include "trajectory/velocity/velocity_command.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

constexpr double kRestShares[] = {1.0, 0.8,  0.64, 0.5, 0.4,  0.32, 0.25,
                                  0.2, 0.16, 0.12, 0.1, 0.07, 0.05};
constexpr int kDescents = 6;
constexpr double kCalmer = 1e-4;  // as a fraction; smaller gains end the search

bool keeps_limits(const Robot& robot, const VelocityStart& start, const Trajectory& motion) {
  for (int i = 0; i < robot.n(); ++i) {
    const double fastest = std::max(robot.max_speed()[i], std::abs(start.qd[i]));
    if (motion.peak(i, 1) > fastest) return false;
    if (motion.range(i).lower < std::min(robot.lower()[i], start.q[i])) return false;
    if (motion.range(i).upper > std::max(robot.upper()[i], start.q[i])) return false;
  }
  return true;
}

double excess_with(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most,
                   const VectorXd& shares) {
  VelocityPieces pieces(start);
  come_to_rest_apart(robot, pieces, shares);
  const Trajectory motion = std::move(pieces).made();
  if (!keeps_limits(robot, start, motion)) return std::numeric_limits<double>::infinity();
  return excess_of(robot, motion, 0.0, motion.duration(), most);
}

}  // namespace

double excess_of(const Robot& robot, const Trajectory& motion, double begin, double end,
                 const ToolSpeeds& most) {
  constexpr int kSamples = 48;
  VectorXd q(robot.n()), qd(robot.n()), qdd(robot.n());
  double excess = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    motion.sample(begin + (end - begin) * k / kSamples, q, qd, qdd);
    excess = std::max(excess, excess_of(jacobian(robot, q) * qd, most));
  }
  return excess;
}

void come_to_rest_apart(const Robot& robot, VelocityPieces& pieces, const VectorXd& shares) {
  for (Eigen::Index i = 0; i < shares.size(); ++i) {
    const double limit = std::max(shares[i] * robot.max_accel()[i], std::abs(pieces.qdd()[i]));
    const Ramp ramp =
        make_ramp(pieces.qd()[i], pieces.qdd()[i], 0.0, limit, shares[i] * robot.max_jerk()[i]);
    pieces.ramp(i, ramp, std::numeric_limits<double>::infinity());
    pieces.settle(i, 0.0);
  }
}

Rest calmest_rest(const Robot& robot, const VelocityStart& start, const ToolSpeeds& most,
                  double calm) {
  Rest best{.shares = VectorXd::Ones(robot.n()), .excess = 0.0};
  best.excess = excess_with(robot, start, most, best.shares);
  for (int round = 0; round < kDescents; ++round) {
    const double before = best.excess;
    for (Eigen::Index i = 0; i < robot.n(); ++i) {
      for (const double share : kRestShares) {
        if (best.excess <= calm) return best;
        VectorXd shares = best.shares;
        shares[i] = share;
        const double excess = excess_with(robot, start, most, shares);
        if (excess < best.excess) best = {std::move(shares), excess};
      }
    }
    if (!(best.excess < before - kCalmer)) break;
  }
  return best;
}

}  // namespace armlet
