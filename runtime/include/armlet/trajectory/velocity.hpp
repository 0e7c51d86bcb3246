// Velocity commands: reach a velocity, hold it, and stop unless another command follows.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "armlet/kinematics/limits.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A law by which the tool reaches a velocity (the take-up).
//
// share    part of the limits on acceleration and jerk for the take-up itself; the rest is for the
//          change of the joint directions during it.
// turning  part of the jerk limit for changing the direction of an acceleration that another
//          command has left.
// ref      joint values to which the law of the take-up refers; empty if it is in joint speeds.
// crosses  whether the direction that the tool has nearly lost at `ref` is left to the joints, in
//          order to come to rest through a singular position.
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

// How the tool reaches a velocity, and the progress so far.
//
// law          of the take-up.
// brake_for    s, for which the tool first decelerates, because reaching the velocity at once would
//              make the tool faster than allowed; mostly 0.
// brake        the law of that deceleration.
// fastest      the largest commanded speeds that are still being reached.
// q, qd, qdd   the state at which the present law began.
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

// The state of a robot when a command arrives, and for how long the command holds, s, > 0.
//
// qdd      empty: no joint accelerates.
// same     `take_up` of the plan before, if this command repeats its velocity when the time of that
//          plan ends: the take-up then continues. Ignored if the state is not the one to which that
//          plan led.
// fastest  `take_up.fastest` of the plan before, if the tool was reaching another velocity. If it
//          is not known, the tool speed at the start is used.
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

// The result of planning a velocity command: a motion, or the reason why there is none.
//
// motion    begins with the state of the start. The speeds are reached as fast as the limits on
//           acceleration and jerk allow, all joints together, and held. When the command ends, also
//           before the speeds are reached, the joints come to rest in the same manner.
//           Accelerations never jump. A repeated command from a state within its time continues the
//           same motion. While a velocity is being reached no speed exceeds the fastest commanded
//           one by more than 1 % (next to a singular position, where no smooth solution is found,
//           one in a thousand exceeds it by a little more, and so does the deceleration).
// outside   a joint would leave its limits, at the latest while it stops.
// too_high  a joint would exceed its limit of speed, acceleration or jerk.
// lacking   part of the velocity of the tool that no joint speeds produce, as a fraction of it.
// take_up   how the tool reaches its velocity, for the next command.
struct VelocityPlan {
  std::optional<Trajectory> motion{};
  std::optional<LimitViolation> outside{};
  std::optional<RateTooHigh> too_high{};
  double lacking = 0.0;
  ToolTakeUp take_up{};
};

// Plans a command for joint speeds.
//
// rates   n joint speeds, rad/s or m/s.
// throws  ArgumentError for sizes that differ, numbers that are not finite, or no duration.
VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const Eigen::VectorXd& rates);

// Plans a command for a velocity of the tool point: v in m/s and w in rad/s, in the world. Of all
// joint speeds that produce it the smallest are chosen.
//
// twist   [v; w] of the tool point, m/s and rad/s, along the axes of the world.
// throws  as plan_joint_velocity.
// source  D. E. Whitney, Resolved motion rate control of manipulators and human prostheses, IEEE
//         Transactions on Man-Machine Systems 10(2), 1969.
VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist);

}  // namespace armlet
