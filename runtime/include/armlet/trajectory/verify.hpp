// The check that every motion passes before anything moves.
#pragma once

#include <optional>
#include <vector>

#include "armlet/kinematics/limits.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Whether a motion has to keep the limits on jerk too. Motions whose accelerations jump cannot.
enum class Jerk { kFree, kLimited };

// What planning a motion of a robot gave.
//
// trajectory  the motion; nothing if it must not be made.
// too_fast    the time is too short; with a trajectory it is advice, limits not being enforced.
// outside     joints that would leave their limits; never together with a trajectory.
struct MotionPlan {
  std::optional<Trajectory> trajectory{};
  std::optional<TooFast> too_fast{};
  std::vector<LimitViolation> outside{};

  [[nodiscard]] bool ok() const { return trajectory.has_value(); }
};

// Speed, acceleration and jerk limits of every joint, in joint order.
std::vector<AxisLimits> axis_limits(const Robot& robot);

// The duration that the path of this trajectory needs at least for the speed and acceleration
// limits, and those on jerk if they count, of every joint; and the joint that decides. Run k times
// slower, speeds fall by k, accelerations by k^2 and jerks by k^3.
//
// motors  an arm whose joints with a finite Joint::max_effort are not limited in acceleration; of
//         their forces motion_forces tells. Null: all are limited.
// throws  ArgumentError unless the trajectory has one path per joint.
// source  J. M. Hollerbach, Dynamic scaling of manipulator trajectories, Journal of Dynamic
//         Systems, Measurement, and Control 106, 1984.
TooFast least_time(const Robot& robot, const Trajectory& trajectory, Jerk jerk = Jerk::kFree,
                   const Robot* motors = nullptr);

// Checks positions, speeds, accelerations and perhaps jerks over the whole motion, exactly. A joint
// that starts outside its limits may only come back.
//
// enforce_limits  false: what is too fast is only reported.
// motors          as for least_time.
// throws          ArgumentError unless the trajectory has one path per joint.
MotionPlan verify(const Robot& robot, Trajectory trajectory, bool enforce_limits = true,
                  Jerk jerk = Jerk::kFree, const Robot* motors = nullptr);

}  // namespace armlet
