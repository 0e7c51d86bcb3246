#include "armlet/chain/walk_plan.hpp"

namespace armlet {
namespace {

Eigen::Isometry3d x_step(const Chain& chain, std::size_t i) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() << 1.0, 0.0, 0.0, 0.0, chain.cos_alpha[i], -chain.sin_alpha[i], 0.0,
      chain.sin_alpha[i], chain.cos_alpha[i];
  X.translation().x() = chain.a[i];
  return X;
}

LinkTwist twist_of(double sin_alpha, double cos_alpha) {
  if (sin_alpha == 0.0 && cos_alpha == 1.0) return LinkTwist::kNone;
  return sin_alpha == 1.0 && cos_alpha == 0.0 ? LinkTwist::kRightAngle : LinkTwist::kAny;
}

// Half a revolution about x remains before T, where it changes the signs of two rows.
void plan_ends(const Chain& chain, double flip, WalkPlan& plan) {
  const std::size_t n = static_cast<std::size_t>(chain.n);
  const Eigen::Isometry3d B = chain.T_world_base * x_step(chain, 0);
  Eigen::Isometry3d T = x_step(chain, n) * chain.T_flange_tool;
  T.matrix().middleRows<2>(1) *= flip;
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t r = 0; r < 3; ++r) {
      const Eigen::Index row = static_cast<Eigen::Index>(r);
      const Eigen::Index column = static_cast<Eigen::Index>(c);
      plan.base[3 * c + r] = B(row, column);
      plan.tool[4 * r + c] = T(row, column);
    }
  }
  plan.base_is_none = B.matrix() == Eigen::Matrix4d::Identity();
  plan.tool_is_flip = T.linear() == Eigen::Vector3d(1.0, flip, flip).asDiagonal().toDenseMatrix();
  plan.tool_on_axis = plan.tool_is_flip && T(0, 3) == 0.0 && T(1, 3) == 0.0;
}

}  // namespace

WalkPlan plan_walk(const Chain& chain) {
  WalkPlan plan;
  plan.n = chain.n;
  plan.standard = chain.standard;
  const std::size_t n = static_cast<std::size_t>(chain.n);
  double flip = 1.0;
  for (std::size_t i = 0; i <= n; ++i) {
    double sin_alpha = chain.sin_alpha[i];
    double cos_alpha = chain.cos_alpha[i];
    const bool inner = i > 0 && i < n;
    if (inner && (sin_alpha < 0.0 || (sin_alpha == 0.0 && cos_alpha < 0.0))) {
      flip = -flip;
      sin_alpha = -sin_alpha;
      cos_alpha = -cos_alpha;
    }
    plan.a[i] = chain.a[i];
    plan.has_a[i] = chain.a[i] != 0.0;
    plan.sin_alpha[i] = sin_alpha;
    plan.cos_alpha[i] = cos_alpha;
    plan.twist[i] = twist_of(sin_alpha, cos_alpha);
    if (i == n) break;
    plan.flip[i] = flip;
    // Adding -0 changes no value, not even -0: without an offset the angle is the joint's value.
    plan.theta[i] = chain.theta[i] == 0.0 ? -0.0 : flip * chain.theta[i];
    plan.q_to_theta[i] = flip * chain.q_to_theta[i];
    plan.d[i] = flip * chain.d[i];
    plan.q_to_d[i] = flip * chain.q_to_d[i];
    plan.has_d[i] = chain.d[i] != 0.0 || chain.q_to_d[i] != 0.0;
  }
  plan_ends(chain, flip, plan);
  return plan;
}

}  // namespace armlet
