#include "armlet/control/make_move.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "control/planning.hpp"

namespace armlet {
namespace control {
namespace {

// Whether the robot stands where the motion starts.
bool check_start(Planning& p, const Trajectory& motion) {
  if (motion.n() != p.model().n()) return p.refuse(refused::WrongJointCount{motion.n()});
  constexpr double kSamePosition = 1e-6;  // as the cell requires
  const Eigen::VectorXd& q = p.state().q;
  const Eigen::VectorXd starts = motion.start();
  Eigen::Index joint = 0;
  if ((starts - q).cwiseAbs().maxCoeff(&joint) <= kSamePosition) return true;
  return p.refuse(refused::StartsElsewhere{static_cast<int>(joint), starts[joint], q[joint]});
}

// A given motion keeps the limits of the robot, or exceeds them as the policies allow.
bool check_limits(Planning& p, Trajectory& motion) {
  const auto verify_it = [&] {
    return verify(p.model(), motion, !p.policies().may_be_too_fast(), Jerk::kFree, p.motors());
  };
  MotionPlan plan = verify_it();
  if (!plan.outside.empty() && lift_limits(p)) plan = verify_it();
  if (!plan.ok() && plan.too_fast) {
    if (const auto time = lengthened(p, *plan.too_fast)) {
      motion = motion.stretched(*time / motion.duration());
      plan = verify_it();
    }
  }
  if (plan.ok() && plan.too_fast) p.report.limits.too_fast.push_back(*plan.too_fast);
  if (!plan.outside.empty())
    return p.refuse(refused::OutsideLimits{plan.outside.front(), refused::Where::kBetween});
  if (!plan.ok()) return p.refuse(*plan.too_fast);
  return true;
}

// The joint that the motion takes farthest beyond the limits of the robot in the cell.
void note_excess(Planning& p) {
  LimitReport& limits = p.report.limits;
  const bool reports = p.policies().limits == LimitCheck::kWarn;
  if (reports) limits.beyond = excesses(*p.state().model, *p.report.planned.motion);
  const LimitViolation* most = farthest(reports ? limits.beyond : limits.clamped);
  if (most != nullptr) limits.excess = {most->joint, most->excess()};
}

bool check_motion(Planning& p) {
  const auto duration = [&] { return p.report.planned.motion->duration(); };
  if (!check_time_left(p, duration(), refused::Lasts::kMotion)) return false;
  if (!check_motors(p)) return false;
  if (!check_time_left(p, duration(), refused::Lasts::kMotion)) return false;
  p.report.collisions =
      check_collisions(p.cell, p.command.robot, *p.report.planned.motion, p.policies());
  if (p.report.collisions.is_refused)
    return p.refuse(refused::Collides{p.report.collisions.certain.front(), duration()});
  note_excess(p);
  return true;
}

}  // namespace

bool plan(Planning& p, const GivenMotion& target) {
  p.report.planned.model = target.model != nullptr ? target.model : p.state().model;
  p.fixed_time = p.command.fixed_time || p.command.time.has_value();
  if (!target.is_verified) {
    if (const auto part = moving_part(p.cell, p.command.robot))
      return p.refuse(refused::Busy{*part});
    if (!check_start(p, target.motion)) return false;
    if (!starts_and_stops(target.motion)) return p.refuse(refused::SpeedJumps{target.planner});
  }
  Trajectory motion = target.motion;
  if (!target.is_verified && !check_limits(p, motion)) return false;
  p.report.planned.length = target.length ? *target.length : between_ends(p.model(), motion);
  p.report.planned.motion = std::move(motion);
  return true;
}

bool check_motors(Planning& p) {
  PlannedMove& planned = p.report.planned;
  p.report.torques =
      check_torques(p.cell, p.command.robot, *planned.motion, p.policies().torques, p.fixed_time);
  if (p.report.torques.is_refused) return p.refuse(refused::TorqueExceeded{});
  const double slower = p.report.torques.slower;
  if (slower <= 1.0) return true;
  planned.motion = planned.motion->stretched(slower);
  for (double& each : planned.times) each *= slower;
  return true;
}

}  // namespace control

std::optional<int> moving_part(const Cell& cell, int index) {
  const CellRobot& robot = cell.robot(index);
  if (robot.hand >= 0 && cell.is_moving(robot.hand)) return robot.hand;
  for (const int finger : robot.fingers) {
    if (cell.is_moving(finger)) return finger;
  }
  if (!robot.motion) return std::nullopt;
  return index;
}

double least_time(double distance, std::optional<double> speed, std::optional<double> accel) {
  if (distance <= 0.0) return 0.0;
  return std::max(speed ? distance / *speed : 0.0, accel ? std::sqrt(distance / *accel) : 0.0);
}

MoveReport plan_move(const Cell& cell, const PlannerSet& planners, const MoveCommand& command) {
  control::Planning p{.cell = cell, .planners = planners, .command = command};
  if (std::visit([&](const auto& target) { return control::plan(p, target); }, command.target))
    control::check_motion(p);
  return std::move(p.report);
}

MoveReport make_move(Cell& cell, const PlannerSet& planners, const MoveCommand& command) {
  MoveReport report = plan_move(cell, planners, command);
  if (!report.ok()) return report;
  report.motion = cell.is_moving(command.robot) ? cell.drive(command.robot, *report.planned.motion)
                                                : cell.start(command.robot, *report.planned.motion);
  return report;
}

MoveReport plan_around(const Cell& cell, const MoveCommand& command, const WayOptions& search) {
  const auto* target = std::get_if<JointTarget>(&command.target);
  if (target == nullptr) throw ArgumentError("A path around obstacles leads to joint values.");
  const PlannerSet none;
  control::Planning p{.cell = cell, .planners = none, .command = command};
  const auto outside = limit_violations(*p.state().model, target->q);
  if (!outside.empty() && command.policies.limits != LimitCheck::kWarn) {
    p.refuse(refused::OutsideLimits{outside.front(), refused::Where::kTarget, target->q});
  } else if (control::prepare(p, control::Needs::kJoints) && control::check_speed(p)) {
    if (!outside.empty()) control::lift_limits(p, target->q);
    if (control::go_around(p, target->q, target->any_branch, search)) control::check_motors(p);
  }
  return std::move(p.report);
}

}  // namespace armlet
