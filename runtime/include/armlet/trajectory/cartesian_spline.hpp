// Moves of the tool on a smooth curve through several poses.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_path.hpp"

namespace armlet {

// How position and orientation run through the poses in time, see spline.hpp; at rest at both ends.
//
// kCubic    cubic interpolator: no overshoot, accelerations jump at the poses.
// kSpline3  cubic spline, continuous accelerations.
// kSpline4  the same with accelerations of zero at both ends.
// kSpline5  quintic spline, the least jerk.
enum class SplineKind { kCubic, kSpline3, kSpline4, kSpline5 };

// A move of the tool through poses, from rest to rest.
//
// poses   in order, of the tool in the world; those where nothing changes are left out.
// task    what of the poses counts, as for LineMove, for all of them.
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

// Plans the move: the legs share the time like the distances between the poses, a turn by one
// radian counting for 0.2 m; position and rotation vector (seen from the first pose, without jumps)
// are splines in time. Solved to joints as for plan_line.
//
// returns  as for a path, `length` being that of the curve, which misses no pose; the fraction of a
//          fault is of its leg's time.
// throws  ArgumentError unless q0 has n finite elements, there is a position, positions are poses,
//         and time and speed are as said.
// source  splines in time as in spline.hpp; splines of the rotation vector: F. C. Park, B. Ravani,
//         Smooth invariant interpolation of rotations, ACM Transactions on Graphics 16(3), 1997,
//         here with one rotation vector for the whole curve.
PathPlan plan_cartesian_spline(const Robot& robot, const SplineMove& move);

}  // namespace armlet
