#pragma once

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

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
  double turn = 0.0;
  double at = 0.0;
  double length = 0.0;

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Follows the line of plan_line through and along singularities: near them the joints are damped,
// so that they stay slow and the tool leaves the line a little. Away from them the line is exact to
// the damping's square.
//
// damping  the smallest singular value of the Jacobian below which joints are damped, above 0;
//          larger values are slower and leave the line further.
// returns  a plan whose `outside` names a joint that would leave its limits.
// throws   as plan_line, and for a damping that is not positive; only with a task of kPose.
// source   Y. Nakamura, H. Hanafusa, Inverse kinematic solutions with singularity robustness, ASME
//          J. Dyn. Sys. Meas. Control 108(3), 1986; S. Chiaverini et al., IEEE T-CST 2(2), 1994.
DampedLine plan_damped_line(const Robot& robot, const LineMove& move, double damping = 0.05);

}  // namespace armlet
