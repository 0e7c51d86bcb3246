#include "canonical_rows.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/dh.hpp"

namespace armlet {
namespace {

constexpr double kSame = 1e-9;  // m, and sines of angles

Eigen::Isometry3d placement(double a, const Angle& alpha) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 1, 0, 0, 0, alpha.c, -alpha.s, 0, alpha.s, alpha.c;
  T.translation().x() = a;
  return T;
}

double snapped(double length) { return std::abs(length) < kSame ? 0.0 : length; }

}  // namespace

Eigen::Isometry3d twist_and_length(const Chain& chain, std::size_t i) {
  return placement(chain.a[i], Angle{chain.cos_alpha[i], chain.sin_alpha[i]});
}

CanonicalRows canonical_rows(const Chain& chain, bool reversed) {
  CanonicalRows rows;
  rows.n = chain.n;
  rows.reversed = reversed;
  const std::size_t n = static_cast<std::size_t>(chain.n);
  const auto x = [&](std::size_t i) { return twist_and_length(chain, i); };
  rows.before = (chain.T_world_base * x(0)).inverse(Eigen::Isometry);
  rows.after = (x(n) * chain.T_flange_tool).inverse(Eigen::Isometry);
  const double direction = reversed ? -1.0 : 1.0;
  double sign = direction;  // of the z axis, relative to the chain's own
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = reversed ? n - 1 - i : i;
    if (i > 0) {
      const std::size_t k = reversed ? n - i : i;
      Angle alpha{chain.cos_alpha[k], direction * chain.sin_alpha[k]};
      if (sign != direction) alpha = {-alpha.c, -alpha.s};  // the remaining half revolution about x
      if (std::abs(alpha.s) < kSame) {
        sign = alpha.c > 0.0 ? direction : -direction;
        alpha = Angle{};
      } else {
        sign = direction;
      }
      rows.alpha[i] = alpha;
      rows.a[i] = snapped(direction * chain.a[k]);
    }
    rows.revolute[i] = chain.revolute[j];
    rows.sign[i] = sign;
    if (chain.revolute[j]) {
      rows.offset[i] = chain.theta[j];
      rows.h[i] = snapped(sign * chain.d[j]);
    } else {
      const det::SinCos theta = det::sincos(sign * chain.theta[j]);
      rows.offset[i] = chain.d[j];
      rows.phi[i] = {theta.cos, theta.sin};
    }
  }
  rows.flipped = sign != direction;
  const Eigen::Isometry3d T_last_tool = x(n) * chain.T_flange_tool;
  if (!reversed) rows.tool_point = T_last_tool.translation();
  if (rows.flipped) rows.tool_point.tail<2>() *= -1.0;
  return rows;
}

Chain with_held_joint(const Chain& chain, bool first, double q) {
  Chain out = chain;
  const std::size_t n = static_cast<std::size_t>(chain.n);
  const std::size_t i = first ? 0 : n - 1;
  const Eigen::Isometry3d Z = dh_pose(
      DhConvention::kStandard,
      {.theta = chain.theta[i] + q * chain.q_to_theta[i], .d = chain.d[i] + q * chain.q_to_d[i]});
  const auto x = [&chain](std::size_t k) { return twist_and_length(chain, k); };
  out.n = chain.n - 1;
  if (!first) {
    out.T_flange_tool = Z * x(n) * chain.T_flange_tool;
    return out;
  }
  out.T_world_base = chain.T_world_base * x(0) * Z;
  const auto shift = [n](auto& values) {
    std::copy(
        values.begin() + 1,
        values.begin() + static_cast<std::ptrdiff_t>(n + 1 < values.size() ? n + 1 : values.size()),
        values.begin());
  };
  for (auto* values : {&out.theta, &out.d, &out.q_to_theta, &out.q_to_d}) shift(*values);
  for (auto* values : {&out.a, &out.sin_alpha, &out.cos_alpha}) shift(*values);
  shift(out.revolute);
  return out;
}

Eigen::Isometry3d CanonicalRows::goal_from_base(const Eigen::Isometry3d& T_base_tool) const {
  Eigen::Isometry3d G = T_base_tool * after;
  if (reversed) G = G.inverse(Eigen::Isometry);
  if (flipped) {
    G.matrix().col(1) = -G.matrix().col(1);
    G.matrix().col(2) = -G.matrix().col(2);
  }
  return G;
}

}  // namespace armlet
