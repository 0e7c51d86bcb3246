#pragma once

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// Of the smallest singular value of the Jacobian, m and m/rad alike.
constexpr double kUsualDamping = 0.05;

// A line that was followed only as well as joints of limited speed can.
//
// motion          verified as for plan_line.
// deviation       the largest distance of the tool point from where it should be, m, and the
//                 largest angle of its orientation, rad. Sampled finely.
// at              where on the line that distance occurs, as a fraction.
// length          of the line, m.
struct DampedLine {
  MotionPlan motion{};
  double deviation = 0.0;
  double angle = 0.0;
  double at = 0.0;
  double length = 0.0;

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Follows the line of plan_line through and along singularities: near them the joints are damped,
// so that they stay slow and the tool leaves the line a little. Away from them the line is exact to
// the damping's square.
//
// The path of the joints is run as fast as their speeds, accelerations and jerks and those of the
// tool allow everywhere, or in the time that is asked for. Where joints all but jump, so that
// limited jerk would take many times as long, accelerations step.
//
// damping  the smallest singular value of the Jacobian below which joints are damped, above 0;
//          larger values are slower and leave the line further.
// returns  a plan whose `outside` names a joint that would leave its limits. With a task of
//          kPositionFirst only the position is followed, and `angle` is 0.
// throws   as plan_line, and for a damping that is not positive; only with a task of kPose or
//          kPositionFirst.
// source   Y. Nakamura, H. Hanafusa, Inverse kinematic solutions with singularity robustness, ASME
//          J. Dyn. Sys. Meas. Control 108(3), 1986; S. Chiaverini et al., IEEE T-CST 2(2), 1994.
DampedLine plan_damped_line(const Robot& robot, const LineMove& move,
                            double damping = kUsualDamping);

// The same along the circle of plan_arc.
//
// p_world_via  in the world, m.
// returns      nothing if there is no arc over the three positions.
// throws       as plan_damped_line.
std::optional<DampedLine> plan_damped_arc(const Robot& robot, const Eigen::Vector3d& p_world_via,
                                          const LineMove& move, double damping = kUsualDamping);

}  // namespace armlet
