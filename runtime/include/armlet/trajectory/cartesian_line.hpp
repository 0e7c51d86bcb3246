#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "armlet/kinematics/ik.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// A straight move of the tool point from rest to rest; the orientation rotates about one fixed axis
// in proportion to the distance.
// source  Siciliano et al., Robotics, 2009, sections 4.3.1 and 4.3.3.
//
// q0              joint values at the start; they determine the branch, which is kept.
// T_world_goal    goal of the tool point. `task` decides which parts of it count: with
//                 kPositionFirst the orientation is kept as far as the arm can, with kHeading only
//                 the rotation about z.
// time            whole duration, s; not together with tool_speed.
// tool_speed      highest speed of the tool point, m/s. The move takes longer if joint limits
//                 demand it. Without time and tool_speed the move is as fast as the joints allow.
// tool_accel      highest acceleration of the tool point along the line, m/s^2; not with time.
// speed           fraction of the joint limits for a move with neither time nor tool_speed, above 0
//                 and at most 1: the fastest move, executed 1/speed times slower.
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
// kGoal   the goal cannot be reached at all; `ik` says why.
// kPath   the goal can be reached, but not a point before it; `ik` says why for that point. If `ik`
//         is ok, only another branch reaches the point, and the arm cannot change to it on the
//         line.
// kJump   a joint would have to jump: the line passes through or next to a singularity.
// kNoArc  for arcs only: two of the three positions are the same, or all lie on one line.
enum class LineFaultKind { kGoal, kPath, kJump, kNoArc };

// Why three positions determine no circle: two of them are the same, or all lie on one line.
enum class NoCircle { kOnOneLine, kStartAndEnd, kStartAndVia, kViaAndEnd };

// fraction   of the length up to which the line can be followed, 0 to 1.
// joint      for kJump, the joint, from 0.
// limit      for kPath, the joint that would leave its limits if the arm continued in its branch.
// no_circle  for kNoArc, the reason.
struct LineFault {
  LineFaultKind kind = LineFaultKind::kGoal;
  double fraction = 0.0;
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();  // the pose that failed
  IkResult ik{};
  int joint = 0;
  std::optional<LimitViolation> limit{};
  NoCircle no_circle = NoCircle::kOnOneLine;
};

// motion  the joint motion, verified; empty if there is a `fault`.
// length  of the line, m.
struct LinePlan {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  double length = 0.0;

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Plans the line. Inverse kinematics finds the joint values at positions along it, each from the
// solution before, so closely that no joint rotates 2 deg (or slides 20 mm) between two of them and
// the tool stays within 1 um of the line; the joints follow quintic splines in time through them.
// The distance along the line is the quintic 10 x^3 - 15 x^4 + 6 x^5 of time, slow enough for the
// limits of the joints on speed, acceleration and jerk.
//
// robot   its joint limits hold; poses are in the world.
// throws  ArgumentError unless q0 has n finite elements, the goal is a pose, and time or tool_speed
//         is positive (time may be 0 if the line has no length), not both.
LinePlan plan_line(const Robot& robot, const LineMove& move);

}  // namespace armlet
