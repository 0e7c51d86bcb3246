#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "armlet/kinematics/ik.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// A straight move of the tool point from rest to rest; the orientation turns evenly about one axis.
// source  Siciliano et al., Robotics, 2009, sections 4.3.1 and 4.3.3.
//
// q0              joints at the start; they choose the branch, which is kept.
// T_world_goal    where the tool point goes. What of it counts is decided by `task`: with
//                 kPositionFirst the orientation is kept as far as the arm can, with kHeading only
//                 the rotation about z.
// time            whole duration, s; not together with tool_speed.
// tool_speed      highest speed of the tool point, m/s. The move takes longer if the joints need
//                 it. With neither, the move is as fast as the joints allow.
// tool_accel      highest acceleration of the tool point along the line, m/s^2; not with time.
// speed           fraction of the joint limits for a move with neither time nor tool_speed, above 0
//                 and at most 1: the move as fast as the joints allow, run 1/speed times slower.
// enforce_limits  false: joint speeds, accelerations and jerks that are too high are only reported.
struct LineMove {
  Eigen::VectorXd q0{};
  Eigen::Isometry3d T_world_goal = Eigen::Isometry3d::Identity();
  IkTask task = IkTask::kPose;
  std::optional<double> time{};
  std::optional<double> tool_speed{};
  std::optional<double> tool_accel{};
  double speed = 1.0;
  bool enforce_limits = true;
};

// Why a line cannot be followed.
//
// kGoal  its end cannot be reached at all; `ik` says why.
// kPath  its end can be reached, a point in between cannot; `ik` says why for that point. If `ik`
//        is ok there, only another configuration of the arm reaches it, which it cannot change
//        into.
// kJump  a joint would have to jump: the line passes through or next to a singularity.
// kNoArc for arcs only: two of the three positions are the same, or all lie on one line.
enum class LineFaultKind { kGoal, kPath, kJump, kNoArc };

// Why three positions determine no circle: which two are the same, or that all lie on one line.
enum class NoCircle { kOnOneLine, kStartAndEnd, kStartAndVia, kViaAndEnd };

// fraction  of the length up to which the line can be followed, 0 to 1.
// joint     for kJump, the joint, counted from 0.
// limit     for kPath, the joint that would leave its limits if the arm went on as it is.
// no_circle for kNoArc, why.
struct LineFault {
  LineFaultKind kind = LineFaultKind::kGoal;
  double fraction = 0.0;
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();  // the pose that failed
  IkResult ik{};
  int joint = 0;
  std::optional<LimitViolation> limit{};
  NoCircle no_circle = NoCircle::kOnOneLine;
};

// motion  the joint motion, verified; nothing in it if `fault` says why.
// length  of the line, m.
struct LinePlan {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  double length = 0.0;

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Plans the line: positions on it are solved to joints, each from the solution before, so finely
// that no joint turns 2 deg (or slides 20 mm) between two of them and the tool stays within 1 um of
// the line in between; the joints follow quintic splines through them in time. Distance runs as the
// quintic 10 x^3 - 15 x^4 + 6 x^5 of time, as slowly as the limits of the joints on speed,
// acceleration and jerk need it.
//
// robot   the limits of its joints count; poses are in the world.
// throws  ArgumentError unless q0 has n finite elements, the goal is a pose, and time or tool_speed
//         is positive (time may be 0 if there is nothing to travel), not both.
LinePlan plan_line(const Robot& robot, const LineMove& move);

}  // namespace armlet
