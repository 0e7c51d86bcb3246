#include "control/planning.hpp"

#include <cmath>

#include "armlet/kinematics/forward.hpp"

namespace armlet::control {

bool takes_over(const Planning& p) {
  const MoveCommand& command = p.command;
  return p.cell.is_moving(command.robot) && p.cell.can_drive(command.robot) && !command.time &&
         (command.planner == "Syn" || command.planner == "SCurve");
}

bool check_time_left(Planning& p, double seconds, refused::Lasts lasts) {
  if (seconds <= p.command.time_left) return true;
  return p.refuse(refused::TooLong{lasts, seconds});
}

bool check_speed(Planning& p) {
  if (!p.command.speed || is_fraction(*p.command.speed)) return true;
  return p.refuse(refused::BadRate{refused::Rate::kSpeed, *p.command.speed});
}

namespace {

bool check_tool_rate(Planning& p, refused::Rate rate, const std::optional<double>& value) {
  if (!value || (std::isfinite(*value) && *value > 0.0)) return true;
  return p.refuse(refused::BadRate{rate, *value});
}

bool check_rates(Planning& p) {
  if (const auto* line = std::get_if<LineTarget>(&p.command.target)) {
    if (!check_tool_rate(p, refused::Rate::kToolSpeed, line->tool_speed)) return false;
    if (!check_tool_rate(p, refused::Rate::kToolAcceleration, line->tool_accel)) return false;
  }
  if (std::holds_alternative<CurveTarget>(p.command.target) && !check_speed(p)) return false;
  if (is_fraction(p.command.accel)) return true;
  return p.refuse(refused::BadRate{refused::Rate::kAcceleration, p.command.accel});
}

void choose_model(Planning& p) {
  const MoveCommand& command = p.command;
  const std::shared_ptr<const Robot>& own = p.state().model;
  p.report.planned.model = own;
  if (!command.T_flange_tool && command.accel == 1.0) return;
  Robot model = *own;
  if (command.T_flange_tool) model = model.with_tool_point(*command.T_flange_tool);
  if (command.accel != 1.0) model = model.with_acceleration(command.accel);
  p.report.planned.model = std::make_shared<const Robot>(std::move(model));
}

}  // namespace

bool prepare(Planning& p, Needs needs) {
  const MoveCommand& command = p.command;
  if (needs == Needs::kToolPoint && p.state().on >= 0) return p.refuse(refused::NoToolPoint{});
  const bool moves_joints = std::holds_alternative<JointTarget>(command.target) ||
                            std::holds_alternative<PoseTarget>(command.target);
  if (!(moves_joints && takes_over(p))) {
    if (const auto part = moving_part(p.cell, command.robot)) return p.refuse(refused::Busy{*part});
  }
  if (command.time) {
    if (!std::isfinite(*command.time) || *command.time < 0.0)
      return p.refuse(refused::BadTime{*command.time});
    if (!check_time_left(p, *command.time, refused::Lasts::kTime)) return false;
  }
  if (!check_rates(p)) return false;
  choose_model(p);
  p.fixed_time = command.fixed_time || command.time.has_value();
  return true;
}

bool lift_limits(Planning& p, const Eigen::VectorXd& q) {
  if (p.policies().limits != LimitCheck::kWarn) return false;
  p.report.planned.model = std::make_shared<const Robot>(with_wider_limits(p.model(), q));
  return true;
}

std::optional<double> lengthened(Planning& p, const TooFast& fast) {
  constexpr double kRounding = 1.0 + 1e-9;
  if (p.policies().limits != LimitCheck::kClamp || !std::isfinite(fast.least_time) ||
      fast.least_time <= fast.given)
    return std::nullopt;
  p.report.limits.lengthened.push_back(fast);
  return fast.least_time * kRounding;
}

double between_ends(const Robot& robot, const Trajectory& motion) {
  return (forward(robot, motion.end()).translation() - forward(robot, motion.start()).translation())
      .norm();
}

}  // namespace armlet::control
