// Moves of the tool along arcs, and along several pieces with rounded corners.
#pragma once

#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_line.hpp"

namespace armlet {

// Plans a move of the tool point along the circle from where it is over `via` to the position of
// move.T_world_goal; the orientation turns evenly about one axis. Everything else is as for
// plan_line, `length` being that of the arc.
//
// p_world_via  in the world, m.
// returns      a plan whose fault is kNoArc if two of the positions are the same (closer together
//              than kSamePosition) or all lie on one line (within 1e-9 of their distance).
// throws       as plan_line.
// source       B. Siciliano et al., Robotics, 2009, section 4.3.1 (circular path).
LinePlan plan_arc(const Robot& robot, const Eigen::Vector3d& p_world_via, const LineMove& move);

// Positions that are closer together are the same for an arc: the plane of the circle and its
// middle would follow from rounding and from how exactly the tool reached its last target. m.
inline constexpr double kSamePosition = 1e-5;

// Why no circle leads over the three positions; nothing: one does.
std::optional<NoCircle> no_circle_over(const Eigen::Vector3d& p_start, const Eigen::Vector3d& p_via,
                                       const Eigen::Vector3d& p_end);

// A position on a path.
//
// q            reached on a straight line of the joints instead, which end there; the two poses
//              below do not count then.
// p_world_via  reached over this position on a circle; nothing: on a straight line.
// blend        how far before and after the position the path may leave its pieces to round the
//              corner, m; at most half the length of either. With 0 the tool stops there.
// tool_speed   highest speed of the tool point on the way to it, m/s, and tool_accel how fast that
//              may change, m/s^2; they hold up to the middle of a corner, those of the next behind.
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
// task   what of the poses counts, as for LineMove, for all positions.
// time   whole duration, s; nothing: as fast as the limits of the joints and tool speeds allow.
// speed  fraction of the joint limits, above 0 and at most 1; not together with time.
// jerk   kFree: as fast as speeds and accelerations alone allow; accelerations jump.
// motors the arm, with what it carries, whose motors count in the place of the accelerations of
//        joints whose Joint::max_effort is finite; null: none. Not with kFree, which is made slower
//        for them by who asks.
struct PathMove {
  Eigen::VectorXd q0{};
  std::vector<PathPoint> points{};
  IkTask task = IkTask::kPose;
  std::optional<double> time{};
  double speed = 1.0;
  Jerk jerk = Jerk::kLimited;
  const Robot* motors = nullptr;
};

// How a path was planned.
//
// motion   verified; nothing in it if `fault` says why.
// point    of the fault, the piece that fails: the one that leads to this position, counted from 0;
//          the fraction of the fault is of that piece.
// length   that the tool point travels, m.
// missed   how far the path passes by each position, m; 0 where it stops.
// times    when it reaches each position, or passes by it, s; only with a motion.
struct PathPlan {
  MotionPlan motion{};
  std::optional<LineFault> fault{};
  int point = 0;
  double length = 0.0;
  std::vector<double> missed{};
  std::vector<double> times{};

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Plans the path: straight pieces and arcs, at the positions rounded by curves whose direction and
// curvature are continuous; solved to joints as for plan_line. A corner beside a straight line of
// the joints is rounded in the space of the joints. The whole is run as fast as possible. Speeds
// fall only where limits need it; accelerations are continuous. Where joints all but jump, so that
// limited jerk would take many times as long, it is not limited.
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
