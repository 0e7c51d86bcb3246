// Moves of the tool on a smooth curve through several poses.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// How place and turn run through the poses in time, see spline.hpp; at rest at both ends.
//
// kCubic    cubic interpolator: no overshoot, accelerations jump at the poses.
// kSpline3  cubic spline, continuous accelerations.
// kSpline4  the same with accelerations of zero at both ends.
// kSpline5  quintic spline, the least jerk.
enum class SplineKind { kCubic, kSpline3, kSpline4, kSpline5 };

// A move of the tool through poses, from rest to rest.
//
// places  in order; those where nothing changes are left out.
// task    what of the poses counts, as for LineMove, for all of them.
// time    whole duration, s; nothing: as fast as the limits of the joints allow.
// speed   fraction of the joint limits, above 0 and at most 1; not together with time.
struct SplineMove {
  Eigen::VectorXd q0{};
  std::vector<Eigen::Isometry3d> places{};
  SplineKind kind = SplineKind::kSpline3;
  IkTask task = IkTask::kPose;
  std::optional<double> time{};
  double speed = 1.0;
};

// How it was planned.
//
// motion  verified; nothing in it if `fault` says why.
// place   of the fault, the leg that fails: the one that leads to this place, counted from 0; the
//         fraction of the fault is of that leg's time.
// length  of the curve, m.
// times   when each place is passed, s; only with a motion.
struct SplinePlan {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  int place = 0;
  double length = 0.0;
  std::vector<double> times{};

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Plans the move: the legs share the time like the distances between the poses, a turn by one
// radian counting for 0.2 m; place and rotation vector (seen from the first pose, without jumps)
// are splines in time. Solved to joints as for plan_line.
//
// throws  ArgumentError unless q0 has n finite elements, there is a place, places are poses, and
//         time and speed are as said.
SplinePlan plan_cartesian_spline(const Robot& robot, const SplineMove& move);

}  // namespace armlet
