#pragma once

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// Threshold on the smallest singular value of the Jacobian, m and m/rad alike.
constexpr double kUsualDamping = 0.05;

// A line that was followed as well as joints of limited speed can.
//
// motion          verified as for plan_line.
// deviation       the largest distance of the tool point from the line, m, and the largest angle of
//                 its orientation from the demanded one, rad. Sampled finely.
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

// Follows the line of plan_line through and along singularities: near them the joint speeds are
// damped, so the tool leaves the line a little. Away from them the error is of the order of the
// square of the damping.
//
// The joint path is followed as fast as the limits of the joints and of the tool allow, or in the
// requested time. Where joints nearly jump, so that limited jerk would take many times as long,
// accelerations jump.
//
// damping  the smallest singular value of the Jacobian below which joints are damped, above 0;
//          larger values make joints slower and the deviation larger.
// returns  a plan whose `outside` names a joint that would leave its limits. With a task of
//          kPositionFirst only the position is followed, and `angle` is 0.
// throws   as plan_line, and for a damping that is not positive; only with a task of kPose or
//          kPositionFirst.
// source   Y. Nakamura, H. Hanafusa, Inverse kinematic solutions with singularity robustness, ASME
//          J. Dyn. Sys. Meas. Control 108(3), 1986; S. Chiaverini et al., IEEE T-CST 2(2), 1994.
DampedLine plan_damped_line(const Robot& robot, const LineMove& move,
                            double damping = kUsualDamping);

// A motion along the circle of plan_arc, damped near singularities.
//
// p_world_via  in the world, m. returns      nothing if there is no arc over the three positions.
// throws       as plan_damped_line.
std::optional<DampedLine> plan_damped_arc(const Robot& robot, const Eigen::Vector3d& p_world_via,
                                          const LineMove& move, double damping = kUsualDamping);

}  // namespace armlet
