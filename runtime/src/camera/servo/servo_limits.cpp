#include "camera/servo/servo_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/math/angles.hpp"

namespace armlet {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRank = 1e-8;  // of the largest singular value

// The largest speed, held for a period, after which a joint can still come to rest within `room`.
double speed_within(double room, double accel, double period) {
  if (!std::isfinite(room)) return room;
  if (!std::isfinite(accel)) return room / period;
  return accel * (std::sqrt(period * period + 2.0 * room / accel) - period);
}

// A motion back from the outer three tenths of the range of each joint.
VectorXd away_from_limits(const ServoArm& arm, const VectorXd& q) {
  constexpr double kFree = 0.7, kRate = 2.0;  // 1/s
  VectorXd out = VectorXd::Zero(q.size());
  for (Index i = 0; i < q.size(); ++i) {
    const double half = 0.5 * (arm.upper[i] - arm.lower[i]);
    if (!std::isfinite(half) || half <= 0.0) continue;
    const double from_middle = q[i] - 0.5 * (arm.upper[i] + arm.lower[i]);
    const double beyond = std::abs(from_middle) - kFree * half;
    if (beyond > 0.0) out[i] = from_middle > 0.0 ? -kRate * beyond : kRate * beyond;
  }
  return out;
}

// The joint whose limit requires the smallest scale.
struct Slowest {
  double scale = 1.0;
  JointAtLimit at{};
};
std::optional<Slowest> slowest_joint(const ServoArm& arm, const VectorXd& q, const VectorXd& qd,
                                     double period) {
  std::optional<Slowest> out;
  for (Index i = 0; i < qd.size(); ++i) {
    if (qd[i] == 0.0) continue;
    const double limit = qd[i] > 0.0 ? arm.upper[i] : arm.lower[i];
    const double room = std::max(0.0, qd[i] > 0.0 ? limit - q[i] : q[i] - limit);
    const double scale = speed_within(room, arm.max_accel[i], period) / std::abs(qd[i]);
    if (scale < (out ? out->scale : 1.0))
      out = Slowest{scale, {.joint = i, .limit = limit, .room = room, .asked = qd[i]}};
  }
  return out;
}

}  // namespace

LimitedSpeeds limited_speeds(const MatrixXd& A, const VectorXd& error, double gain,
                             const ServoArm& arm, const VectorXd& q, double period) {
  MatrixXd free = A;
  const Index rank = rank_above(A, kRank);
  VectorXd away = away_from_limits(arm, q);
  std::vector<Index> left_out;
  LimitedSpeeds out;
  for (;;) {
    out.qd = servo_step(free, error, gain).motion;
    if (rank < A.cols()) out.qd += null_motion(free, away);
    for (const Index i : left_out) out.qd[i] = 0.0;
    double scale = 1.0;
    for (Index i = 0; i < q.size(); ++i) {
      const double speed = std::abs(out.qd[i]);
      if (speed * scale > arm.max_speed[i]) scale = arm.max_speed[i] / speed;
    }
    const auto slowest = slowest_joint(arm, q, scale * out.qd, period);
    out.scale = scale;
    if (slowest) {
      MatrixXd without = free;
      without.col(slowest->at.joint).setZero();
      if (rank_above(without, kRank) == rank) {
        free = without;
        away[slowest->at.joint] = 0.0;
        left_out.push_back(slowest->at.joint);
        continue;
      }
      out.scale *= slowest->scale;
      out.at = slowest->at;
    }
    out.qd *= out.scale;
    return out;
  }
}

std::string joint_text(const ServoArm& arm, Index joint, double value) {
  return arm.turns[static_cast<std::size_t>(joint)] ? fmt::format("{:.4g} deg", value * 180.0 / kPi)
                                                    : fmt::format("{:.4g} mm", value * 1000.0);
}

}  // namespace armlet
