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

// Where a robot is when a command comes, and for how long the command holds, s, > 0.
struct VelocityStart {
  Eigen::VectorXd q{};
  Eigen::VectorXd qd{};
  double during = 0.0;
};

// A joint would have to exceed a limit on its speed or acceleration.
struct RateTooHigh {
  int joint = 0;
  LimitKind kind = LimitKind::kSpeed;
  double value = 0.0;  // magnitude
  double limit = 0.0;
};

// What planning a velocity command gave: a motion, or why there is none.
//
// motion    begins with the position and speed of the start. The speeds change evenly, all joints
//           together, as fast as their accelerations allow; then they are held. When the command
//           ends, also before the speeds are reached, the joints come to rest the same way.
// outside   a joint would leave its limits, at the latest while it stops.
// too_high  a joint would be too fast, or gain speed too fast.
// lacking   part of the velocity of the tool that no joint speeds give, as a fraction of it.
struct VelocityPlan {
  std::optional<Trajectory> motion{};
  std::optional<LimitViolation> outside{};
  std::optional<RateTooHigh> too_high{};
  double lacking = 0.0;
};

// Holds joint speeds, rad/s or m/s.
// throws  ArgumentError for sizes that differ, numbers that are not finite, or no duration.
VelocityPlan plan_joint_velocity(const Robot& robot, const VelocityStart& start,
                                 const Eigen::VectorXd& rates);

// Holds a velocity of the tool point: v in m/s and w in rad/s, in the world. Of the joint speeds
// that give it the smallest ones are taken.
// throws  as plan_joint_velocity.
VelocityPlan plan_tool_velocity(const Robot& robot, const VelocityStart& start,
                                const Vector6d& twist);

}  // namespace armlet
