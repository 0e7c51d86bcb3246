#include "armlet/math/check_finite.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "trajectory/tool/curve_plan.hpp"

namespace armlet {

LinePlan plan_arc(const Robot& robot, const Eigen::Vector3d& p_world_via, const LineMove& move) {
  check_finite("p_world_via", p_world_via);
  return plan_curve(robot, move,
                    [&](const Eigen::Isometry3d& T_start,
                        const Eigen::Isometry3d& T_end) -> std::optional<CurvePiece> {
                      return piece_over(T_start, p_world_via, T_end);
                    });
}

}  // namespace armlet
