// Moves of the tool on a smooth curve through several poses.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_path.hpp"

namespace armlet {

// How position and orientation pass through the poses in time, see spline.hpp; at rest at both
// ends.
//
// kCubic    cubic interpolator: no overshoot, accelerations jump at the poses.
// kSpline3  cubic spline, continuous accelerations.
// kSpline4  the same with accelerations of zero at both ends.
// kSpline5  quintic spline, the least jerk.
enum class SplineKind { kCubic, kSpline3, kSpline4, kSpline5 };

// A move of the tool through poses, from rest to rest.
//
// poses   in order, of the tool in the world; a pose equal to the one before is left out.
// task    parts of the poses that count, as for LineMove, for all of them.
// time    whole duration, s; nothing: as fast as the limits of the joints allow.
// speed   fraction of the joint limits, above 0 and at most 1; not together with time.
struct SplineMove {
  Eigen::VectorXd q0{};
  std::vector<Eigen::Isometry3d> poses{};
  SplineKind kind = SplineKind::kSpline3;
  IkTask task = IkTask::kPose;
  std::optional<double> time{};
  double speed = 1.0;
};

// Plans the move. The time is divided among the legs in proportion to the distances between poses;
// a rotation by one radian counts as 0.2 m. Position and rotation vector (relative to the first
// pose, continuous) are splines in time. Inverse kinematics as for plan_line.
//
// returns  as for a path; `length` is that of the curve, which passes through every pose; the
//          fraction of a fault is of its leg's time.
// throws  ArgumentError unless q0 has n finite elements, there is a position, positions are poses,
//         and time and speed are as said.
// source  splines in time as in spline.hpp; splines of the rotation vector: F. C. Park, B. Ravani,
//         Smooth invariant interpolation of rotations, ACM Transactions on Graphics 16(3), 1997,
//         here with one rotation vector for the whole curve.
PathPlan plan_cartesian_spline(const Robot& robot, const SplineMove& move);

}  // namespace armlet
