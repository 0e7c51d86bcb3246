// Moves of the tool along arcs, and along several segments with rounded corners.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// Plans a move of the tool point along the circle from its present position over `via` to the
// position of move.T_world_goal. The orientation rotates about one fixed axis in proportion to the
// distance. Everything else is as for plan_line; `length` is that of the arc.
//
// p_world_via  in the world, m.
// returns      a plan whose fault is kNoArc if two of the positions are the same (closer together
//              than kSamePosition) or all lie on one line (within 1e-9 of their distance).
// throws       as plan_line.
// source       B. Siciliano et al., Robotics, 2009, section 4.3.1 (circular path).
LinePlan plan_arc(const Robot& robot, const Eigen::Vector3d& p_world_via, const LineMove& move);

// For an arc, positions that are closer together count as the same: otherwise the plane and the
// centre of the circle would depend on rounding and on how exactly the tool reached its last
// target. m.
inline constexpr double kSamePosition = 1e-5;

// Why there is no circle through the three positions; nothing: there is one.
std::optional<NoCircle> no_circle_over(const Eigen::Vector3d& p_start, const Eigen::Vector3d& p_via,
                                       const Eigen::Vector3d& p_end);

// A position on a path.
//
// q            joint values to which a straight segment in joint space leads; the two poses below
//              are ignored then.
// p_world_via  position in the middle of an arc that leads here; nothing: the segment is straight.
// blend        distance before and after the position at which the path may leave its segments to
//              round the corner, m; at most half the length of either. With 0 the tool stops there.
// tool_speed   highest speed of the tool point on the segment to this position, m/s; tool_accel is
//              its highest acceleration, m/s^2. They hold up to the middle of a corner, those of
//              the next segment after it.
struct PathPoint {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  std::optional<Eigen::VectorXd> q{};
  std::optional<Eigen::Vector3d> p_world_via{};
  double blend = 0.0;
  std::optional<double> tool_speed{};
  std::optional<double> tool_accel{};
};

// A path of the tool through several positions, from rest to rest.
//
// task    parts of the poses that count, as for LineMove, for all positions.
// time    whole duration, s; nothing: as fast as the limits of the joints and tool speeds allow.
// speed   fraction of the joint limits, above 0 and at most 1; not together with time.
// jerk    kFree: as fast as limits on speed and acceleration alone allow; accelerations jump.
// motors  the arm, with what it carries. The force limits of its motors replace the acceleration
//         limits of joints whose Joint::max_effort is finite; null: no such limits. Not with kFree:
//         there the caller slows the motion down until the motors suffice.
struct PathMove {
  Eigen::VectorXd q0{};
  std::vector<PathPoint> points{};
  IkTask task = IkTask::kPose;
  std::optional<double> time{};
  double speed = 1.0;
  Jerk jerk = Jerk::kLimited;
  const Robot* motors = nullptr;
};

// A planned path.
//
// motion   verified; empty if there is a `fault`.
// point    of the fault: the segment that fails, given by the position to which it leads, from 0;
//          the fraction of the fault is of that segment.
// length   of the path of the tool point, m.
// missed   distance between the path and each position, m; 0 where it stops.
// times    at which the motion reaches or passes each position, s; only with a motion.
struct PathPlan {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  int point = 0;
  double length = 0.0;
  std::vector<double> missed{};
  std::vector<double> times{};

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Plans the path: straight segments and arcs, with corners rounded by curves of continuous
// direction and curvature; inverse kinematics as for plan_line. A corner next to a segment in joint
// space is rounded in joint space. The path is followed as fast as possible: speed drops only where
// limits demand it, and accelerations are continuous. Where joints nearly jump, so that limited
// jerk would take many times as long, jerk is not limited.
//
// source  rounding: p(u) = P - r d1 + 2 r (d1 u + (d2 - d1)(u^3 - u^4 / 2)), which misses the
//         corner by 3/16 r |d2 - d1|. Time: D. Verscheure and others, Time-optimal path tracking
//         for robots, IEEE TAC 54(10), 2009, with the jerk limited too; for Jerk::kFree
//         fastest_run.
// throws  ArgumentError unless q0 has n finite elements, there is a position, poses are poses,
//         blends are not negative and speeds are positive, or for time together with a speed below
//         1.
PathPlan plan_path(const Robot& robot, const PathMove& move);

}  // namespace armlet
