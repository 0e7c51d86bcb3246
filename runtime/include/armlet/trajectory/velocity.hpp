// Velocity commands: take up a velocity, hold it, and stop unless another command takes over.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "armlet/kinematics/limits.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A law by which the tool takes up a velocity.
//
// share    part of the limits on acceleration and jerk that is for the take-up itself; the rest is
//          for the joints turning under it.
// turning  part of the limit on jerk with which an acceleration that another command has left is
//          turned.
// ref      position of the joints to which the law of the take-up refers; empty if it is in joint
//          speeds.
// crosses  whether the direction that the tool has all but lost at `ref` is left to the joints, to
//          come to rest through a singular position.
struct ToolLaw {
  double share = 1.0;
  double turning = 1.0;
  Eigen::VectorXd ref{};
  bool crosses = false;
};

// Speeds of the tool point, m/s and rad/s, >= 0.
struct ToolSpeeds {
  double v = 0.0;
  double w = 0.0;
};

// How the tool takes up a velocity, and how far it has come.
//
// law          of the take-up.
// brake_for    s, for which the tool is slowed down first, because the velocity cannot be taken up
//              at once without making the tool faster than it may be; mostly 0.
// brake        the law by which it is slowed down.
// fastest      the largest speeds that were asked for and are still being taken up.
// q, qd, qdd   the state in which the law that is now followed began.
// elapsed      s, since then.
struct ToolTakeUp {
  ToolLaw law{};
  double brake_for = 0.0;
  ToolLaw brake{};
  ToolSpeeds fastest{};
  Eigen::VectorXd q{};
  Eigen::VectorXd qd{};
  Eigen::VectorXd qdd{};
  double elapsed = 0.0;
};

// The state of a robot when a command comes, and for how long the command holds, s, > 0.
//
// qdd      none gains speed if empty.
// same     `take_up` of the plan before, if this command sends the same velocity of the tool again
//          when the time of that plan ends: the take-up then goes on where it is. Left aside if the
//          state is not the one which that plan led to.
// fastest  `take_up.fastest` of the plan before, if the tool was taking up another velocity. If it
//          is not known, what the tool does at the start counts.
struct VelocityStart {
  Eigen::VectorXd q{};
  Eigen::VectorXd qd{};
  Eigen::VectorXd qdd{};
  double during = 0.0;
  std::optional<ToolTakeUp> same{};
  std::optional<ToolSpeeds> fastest{};
};

// A joint would have to exceed a limit on its speed, acceleration or jerk.
struct RateTooHigh {
  int joint = 0;
  LimitKind kind = LimitKind::kSpeed;
  double value = 0.0;  // magnitude
  double limit = 0.0;
};

// What planning a velocity command gave: a motion, or why there is none.
//
// motion    begins with the state of the start. The speeds are taken up as fast as the limits on
//           acceleration and jerk allow, all joints together, and held. When the command ends, also
//           before the speeds are reached, the joints come to rest the same way. Accelerations
//           never jump. The same command sent again from a state within its time goes on with the
//           same motion, and while a velocity is taken up no speed exceeds the fastest velocity
//           that was still being taken up (but for 1 %; next to a singular position, where no calm
//           way is found, one of a thousand by a little more, and the path to rest as well).
// outside   a joint would leave its limits, at the latest while it stops.
// too_high  a joint would be too fast, or gain speed or acceleration too fast.
// lacking   part of the velocity of the tool that no joint speeds give, as a fraction of it.
// take_up   how the tool takes up its velocity, for the command after this one.
struct VelocityPlan {
  std::optional<Trajectory> motion{};
  std::optional<LimitViolation> outside{};
  std::optional<RateTooHigh> too_high{};
  double lacking = 0.0;
  ToolTakeUp take_up{};
};

// Holds joint speeds.
//
// rates   n joint speeds, rad/s or m/s.
// throws  ArgumentError for sizes that differ, numbers that are not finite, or no duration.
VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const Eigen::VectorXd& rates);

// Holds a velocity of the tool point: v in m/s and w in rad/s, in the world. Of the joint speeds
// that give it the smallest ones are taken.
//
// twist   [v; w] of the tool point, m/s and rad/s, along the axes of the world.
// throws  as plan_joint_velocity.
// source  D. E. Whitney, Resolved motion rate control of manipulators and human prostheses, IEEE
//         Transactions on Man-Machine Systems 10(2), 1969.
VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist);

}  // namespace armlet
