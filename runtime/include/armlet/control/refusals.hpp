// Why a move is refused, with the facts that a message needs.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <variant>

#include "armlet/cell/way_around.hpp"
#include "armlet/control/move_command.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/trajectory/cartesian_line.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

namespace refused {

// The robot moves, or a part of the same hand with fingers: its index in the cell.
struct Busy {
  int robot = 0;
};

// A hand with fingers has no tool point.
struct NoToolPoint {};

// The joint values, or those of the given motion, are not those of this robot.
struct WrongJointCount {
  int count = 0;
};

struct UnknownPlanner {
  std::string name;
};

// The time of the command is not a number, infinite or negative, s.
struct BadTime {
  double seconds = 0.0;
};

// A speed or acceleration of the command: a fraction of the limits of the joints outside (0, 1], or
// a value for the tool that is not above 0, m/s or m/s^2.
enum class Rate { kSpeed, kAcceleration, kToolSpeed, kToolAcceleration };
struct BadRate {
  Rate rate = Rate::kSpeed;
  double value = 0.0;
};

// The move would take longer than the time that is left. kTime: the time of the command; kSpeed,
// kAcceleration: the least time for that speed or acceleration of the tool; kMotion: the planned
// motion.
enum class Lasts { kTime, kSpeed, kAcceleration, kMotion };
struct TooLong {
  Lasts lasts = Lasts::kMotion;
  double seconds = 0.0;
};

// The arm cannot tilt its tool so, whatever its joint values.
struct Tilted {
  ToolPose pose{};
};

// `ik` says why.
struct Unreachable {
  Eigen::Isometry3d T_world_goal = Eigen::Isometry3d::Identity();
  IkResult ik{};
};

// The tool cannot follow a line, arc or curve from the joint values q_start to the pose.
struct LineBlocked {
  LineFault fault{};
  Eigen::VectorXd q_start{};
  ToolPose pose{};
};

// A joint would leave its limits: at the target q, or on the way between the targets.
enum class Where { kTarget, kBetween };
struct OutsideLimits {
  LimitViolation violation{};
  Where where = Where::kTarget;
  Eigen::VectorXd q{};
};

// The time is 0 s, and the tool has to go this distance, m.
struct NoTime {
  double distance = 0.0;
};

// The motion of this planner does not begin and end at rest.
struct SpeedJumps {
  std::string planner;
};

// The given motion starts with a joint at one value, and the joint is at another one, rad or m.
struct StartsElsewhere {
  int joint = 0;
  double starts = 0.0;
  double stands = 0.0;
};

// No motion around the obstacles was found; the status of the search says why.
//
// goals  number of joint values that were tried as goals.
struct NoWayAround {
  WayAround around{};
  std::size_t goals = 1;
};

// A collision, in a motion of this duration, s.
struct Collides {
  CellCollision met{};
  double duration = 0.0;
};

// A motor would exceed its limit: MoveReport::torques says which.
struct TorqueExceeded {};

// A precondition of a planner is broken, as its sentence says.
struct Invalid {
  std::string sentence;
};

}  // namespace refused

using Refusal = std::variant<refused::Busy, refused::NoToolPoint, refused::WrongJointCount,
                             refused::UnknownPlanner, refused::BadTime, refused::BadRate,
                             refused::TooLong, refused::Tilted, refused::Unreachable,
                             refused::LineBlocked, refused::OutsideLimits, TooFast, refused::NoTime,
                             refused::SpeedJumps, refused::StartsElsewhere, refused::NoWayAround,
                             refused::Collides, refused::TorqueExceeded, refused::Invalid>;

}  // namespace armlet
