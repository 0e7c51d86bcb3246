// The check that every motion passes before anything moves.
#pragma once

#include <optional>
#include <vector>

#include "armlet/kinematics/limits.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Whether jerk limits apply to a motion. They cannot if accelerations jump.
enum class Jerk { kFree, kLimited };

// The result of planning a motion of a robot.
//
// trajectory  the motion; nothing if it must not be executed.
// too_fast    the time is too short; with a trajectory it is advice, since limits are not enforced.
// outside     joints that would leave their limits; never together with a trajectory.
struct MotionPlan {
  std::optional<Trajectory> trajectory{};
  std::optional<TooFast> too_fast{};
  std::vector<LimitViolation> outside{};

  [[nodiscard]] bool ok() const { return trajectory.has_value(); }
};

// Speed, acceleration and jerk limits of every joint, in joint order.
std::vector<AxisLimits> axis_limits(const Robot& robot);

// The least duration of this path under the limits of every joint on speed, acceleration and, if
// they apply, jerk; and the joint that determines it. A motion k times slower has speeds smaller by
// k, accelerations by k^2 and jerks by k^3.
//
// motors  an arm whose joints with a finite Joint::max_effort have no acceleration limit here,
//         since motion_forces checks their forces. Null: the acceleration limits of all joints
//         apply.
// throws  ArgumentError unless the trajectory has one path per joint.
// source  J. M. Hollerbach, Dynamic scaling of manipulator trajectories, Journal of Dynamic
//         Systems, Measurement, and Control 106, 1984.
TooFast least_time(const Robot& robot, const Trajectory& trajectory, Jerk jerk = Jerk::kFree,
                   const Robot* motors = nullptr);

// Checks positions, speeds, accelerations and possibly jerks over the whole motion, exactly. A
// joint that starts outside its limits may only move towards them.
//
// enforce_limits  false: a motion that is too fast is only reported.
// motors          as for least_time.
// throws          ArgumentError unless the trajectory has one path per joint.
MotionPlan verify(const Robot& robot, Trajectory trajectory, bool enforce_limits = true,
                  Jerk jerk = Jerk::kFree, const Robot* motors = nullptr);

}  // namespace armlet
