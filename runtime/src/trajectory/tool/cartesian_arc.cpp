#include "armlet/math/check_finite.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "trajectory/tool/curve_plan.hpp"

namespace armlet {

LinePlan plan_arc(const Robot& robot, const Eigen::Vector3d& p_world_via, const LineMove& move) {
  check_finite("p_world_via", p_world_via);
  NoCircle why = NoCircle::kOnOneLine;
  LinePlan plan = plan_curve(
      robot, move,
      [&](const Eigen::Isometry3d& T_start,
          const Eigen::Isometry3d& T_end) -> std::optional<CurvePiece> {
        why = no_circle_over(T_start.translation(), p_world_via, T_end.translation()).value_or(why);
        return piece_over(T_start, p_world_via, T_end);
      });
  if (plan.fault && plan.fault->kind == LineFaultKind::kNoArc) plan.fault->no_circle = why;
  return plan;
}

std::optional<NoCircle> no_circle_over(const Eigen::Vector3d& p_start, const Eigen::Vector3d& p_via,
                                       const Eigen::Vector3d& p_end) {
  const auto same = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).norm() <= kSamePosition;
  };
  if (same(p_start, p_end)) return NoCircle::kStartAndEnd;
  if (same(p_start, p_via)) return NoCircle::kStartAndVia;
  if (same(p_via, p_end)) return NoCircle::kViaAndEnd;
  if (!arc_through(p_start, p_via, p_end)) return NoCircle::kOnOneLine;
  return std::nullopt;
}

}  // namespace armlet
