#pragma once
// A move while it is planned. The functions return false if the report has a refusal.

#include <algorithm>
#include <optional>
#include <utility>

#include "armlet/control/make_move.hpp"
#include "armlet/control/tool_goals.hpp"

namespace armlet::control {

// fixed_time  the motion may not be made slower.
struct Planning {
  const Cell& cell;
  const PlannerSet& planners;
  const MoveCommand& command;
  MoveReport report{};
  bool fixed_time = false;

  [[nodiscard]] const CellRobot& state() const { return cell.robot(command.robot); }
  [[nodiscard]] const Robot& model() const { return *report.planned.model; }
  [[nodiscard]] const MovePolicies& policies() const { return command.policies; }
  // The arm whose motors limit the move; null: they do not.
  [[nodiscard]] const Robot* motors() const {
    return policies().limits_torques() ? state().loaded.get() : nullptr;
  }
  bool refuse(Refusal why) {
    report.refusal = std::move(why);
    return false;
  }
};

// Checks the time, the accelerations and whether the robot is free, and chooses the model. A pose
// target needs a tool point.
enum class Needs { kJoints, kToolPoint };
bool prepare(Planning& p, Needs needs);

// Refuses a fraction of the speed limits that is none.
bool check_speed(Planning& p);

// The planned motion has to end in the time that is left.
bool check_time_left(Planning& p, double seconds, refused::Lasts lasts);

// Whether this move continues from the present speeds of the robot.
[[nodiscard]] bool takes_over(const Planning& p);

// With LimitCheck::kWarn: gives the move wider limits on joint values, which contain `q`, and
// returns true. Otherwise the limits hold.
bool lift_limits(Planning& p, const Eigen::VectorXd& q = {});

// With LimitCheck::kClamp: the longer time of a motion that is too fast. Otherwise nullopt.
std::optional<double> lengthened(Planning& p, const TooFast& fast);

// Plans a motion again that is too fast for the given time. With kClamp: in the shortest time. If
// it may be too fast: as fast as the joints allow, then played faster to keep the given time.
// Otherwise nothing changes.
//
// time  the time used for planning; it is updated.
// plan  has `motion` and the `times` at its points; plan_again() makes another one with the updated
//       time, or without a time.
template <class Plan, class PlanAgain>
void keep_time(Planning& p, std::optional<double>& time, Plan& plan, const PlanAgain& plan_again) {
  if (plan.ok() || !plan.motion.too_fast || !time || !(*time > 0.0)) return;
  const TooFast fast = *plan.motion.too_fast;
  const double given = *time;
  const std::optional<double> longer = lengthened(p, fast);
  if (!longer && !p.policies().may_be_too_fast()) return;
  time = longer;
  plan = plan_again();
  if (longer || !plan.ok()) return;
  const double share = given / plan.motion.trajectory->duration();
  plan.motion.trajectory = plan.motion.trajectory->stretched(share);
  for (double& each : plan.times) each *= share;
  p.report.limits.too_fast.push_back(fast);
}

// The straight distance of the tool point between the ends of a motion, m.
[[nodiscard]] double between_ends(const Robot& robot, const Trajectory& motion);

// One planning function for each target; they fill report.planned.
bool plan(Planning& p, const JointTarget& target);
bool plan(Planning& p, const PoseTarget& target);
bool plan(Planning& p, const LineTarget& target);
bool plan(Planning& p, const CurveTarget& target);
bool plan(Planning& p, const PathTarget& target);
bool plan(Planning& p, const GivenMotion& target);

// Searches a motion around obstacles to joint values.
bool go_around(Planning& p, const Eigen::VectorXd& q, bool any_branch, const WayOptions& search);

// Torques, if necessary with a slower motion.
bool check_motors(Planning& p);

}  // namespace armlet::control
