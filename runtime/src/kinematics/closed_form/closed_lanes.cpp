#include "closed_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"

namespace armlet {
namespace {

// Bounds for the length of a link between two revolute joints, and for a squared sine that rounding
// may make negative.
constexpr double kNoLink = 1e-12;  // m
constexpr double kRounding = 1e-5;

void to_columns(const Eigen::Isometry3d& T, double* columns) {
  for (Eigen::Index c = 0; c < 4; ++c) {
    for (Eigen::Index r = 0; r < 3; ++r) *columns++ = T(r, c);
  }
}

// X_i of the point (0, 0, h_i): the intersection of the next axes, after joint i - 1.
std::array<double, 3> behind(const CanonicalRows& rows, std::size_t i) {
  return {rows.a[i], -rows.alpha[i].s * rows.h[i], rows.alpha[i].c * rows.h[i]};
}

}  // namespace

ClosedKernel* closed_kernel_for(InstructionSet set) {
  switch (set) {
    case InstructionSet::kBaseline:
      return kBaselineClosed;
    case InstructionSet::kAvx2:
      return kAvx2Closed;
    default:
      return kAvx512Closed;
  }
}

std::unique_ptr<LaneForm> LaneForm::make(ClosedFormKind kind, const CanonicalRows& rows,
                                         const Chain& chain) {
  const auto turns = [&rows](std::size_t i) { return rows.revolute[i]; };
  if (rows.n != kSixJoints ||
      !(turns(0) && turns(1) && turns(2) && turns(3) && turns(4) && turns(5)))
    return nullptr;
  const auto form = [&](LaneFamily family) {
    auto lanes = std::unique_ptr<LaneForm>(new LaneForm(family, rows, chain));
    return std::isfinite(lanes->arm_.links.scale) ? std::move(lanes) : nullptr;
  };
  switch (kind) {
    case ClosedFormKind::kSphericalParallel:
      return form(LaneFamily::kSphericalParallel);
    case ClosedFormKind::kSphericalMeeting:
      return form(LaneFamily::kSphericalMeeting);
    case ClosedFormKind::kThreeParallel:
      return form(LaneFamily::kThreeParallel);
    default:
      return nullptr;
  }
}

LaneForm::LaneForm(LaneFamily family, const CanonicalRows& rows, const Chain& chain)
    : rows_(rows), plan_(plan_walk(chain)) {
  arm_.family = family;
  arm_.walk = batch_arm(plan_);
  arm_.reversed = rows.reversed;
  for (std::size_t i = 0; i < kSixJoints; ++i) {
    const std::size_t joint = rows.reversed ? kSixJoints - 1 - i : i;
    arm_.alpha[i] = {rows.alpha[i].c, rows.alpha[i].s};
    arm_.a[i] = rows.a[i];
    arm_.h[i] = rows.h[i];
    arm_.sign[i] = rows.sign[i];
    arm_.offset[i] = wrap_angle(rows.offset[i]);
    arm_.walk_sign[i] = rows.sign[i] * plan_.flip[joint];
  }
  arm_.inverse_ss = 1.0 / (rows.alpha[4].s * rows.alpha[5].s);
  arm_.right_wrist = rows.alpha[4].c == 0.0 && rows.alpha[5].c == 0.0;
  prepare_links();
}

void LaneForm::prepare_links() {
  const bool three = arm_.family == LaneFamily::kThreeParallel;
  const auto point = behind(rows_, three ? 4 : 3);
  std::ranges::copy(point, arm_.point);
  arm_.height = arm_.h[1] + arm_.h[2] + point[2] + (three ? arm_.h[3] : 0.0);
  if (arm_.family == LaneFamily::kSphericalMeeting) {
    const double z = point[2] + arm_.h[2];
    const double a = arm_.a[2];
    const double h = arm_.h[1];
    const PlainAngle& alpha = arm_.alpha[2];
    arm_.meeting.A = 2.0 * (a * point[0] + h * alpha.s * point[1]);
    arm_.meeting.B = 2.0 * (h * alpha.s * point[0] - a * point[1]);
    arm_.meeting.fixed =
        a * a + point[0] * point[0] + point[1] * point[1] + z * z + h * h + 2.0 * h * alpha.c * z;
    arm_.links.scale = std::hypot(arm_.meeting.A, arm_.meeting.B) > kNoLink ? 1.0 : INFINITY;
    return;
  }
  const double l = arm_.a[2];
  const double mx = three ? arm_.a[3] : point[0];
  const double my = three ? 0.0 : point[1];
  const double m = std::sqrt(mx * mx + my * my);
  const double sign = l < 0.0 ? -1.0 : 1.0;
  const double size = std::abs(l) + m;
  arm_.links.l = l;
  arm_.links.m_l = m * sign;
  arm_.links.scale =
      std::abs(l) > kNoLink && m > kNoLink ? 1.0 / (2.0 * std::abs(l) * m) : INFINITY;
  arm_.links.m_back = {sign * mx / m, -sign * my / m};
  arm_.links.sum2 = size * size;
  arm_.links.difference2 = (std::abs(l) - m) * (std::abs(l) - m);
  arm_.slack = kRounding * 2.0 * arm_.links.sum2 * arm_.links.scale;
}

bool LaneForm::solve(const Eigen::Isometry3d& T_world_tool, ClosedLanes& out,
                     ClosedKernel& kernel) const {
  const Eigen::Isometry3d T_base_tool = rows_.before * T_world_tool;
  ClosedGoal goal;
  to_columns(T_base_tool, goal.base);
  to_columns(rows_.goal_from_base(T_base_tool), goal.rows);
  return kernel(arm_, goal, out);
}

}  // namespace armlet
