#include "moves/moves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/control/tool_goals.hpp"
#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_waiting.hpp"
#include "moves/move_words.hpp"
#include "moves/paths.hpp"
#include "values/bind.hpp"
#include "values/time_left.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {

Answer<PosC> in_world(Vm& vm, const MoveCall& call, const MoveSettings& settings,
                      const PosC& target) {
  std::optional<Frame> frame = settings.frame ? settings.frame : settings_of(vm).frame;
  if (!frame) return target;
  if (const auto* body = std::get_if<ObjectRef>(&*frame)) {
    const Object* object = find_object(vm, body->name);
    if (object == nullptr) return fail_unknown_object(vm, body->name, call.target);
    frame = object->T_world_obj;
  } else if (const auto* named = std::get_if<FrameRef>(&*frame)) {
    const auto now = frame_now(vm, *named, call.target);
    if (!now) return Failed{};
    frame = now->T;
  }
  return PosC{std::get<Eigen::Isometry3d>(*frame) * target.T, target.has_orientation};
}

void choose_model(Vm& vm, MoveCall& call, const MoveSettings& settings, double accel) {
  const BlockSettings block = settings_of(vm);
  const auto& tool = settings.T_flange_tool ? settings.T_flange_tool : block.T_flange_tool;
  if (!tool && accel == 1.0) return;
  Robot model = *Host::of(vm).cell().robot(call.robot).model;
  if (tool) model = model.with_tool_point(*tool);
  if (accel != 1.0) model = model.with_acceleration(accel);
  call.model = std::make_shared<const Robot>(std::move(model));
}

Answer<void> check_fraction(Vm& vm, const char* what, double value, CallPart part) {
  constexpr double kLeast = 1e-9;  // a revolution would take years
  if (value >= kLeast && value <= 1.0) return {};
  const char* range = value > 0.0 && value < kLeast ? "from 1e-9 to 1" : "above 0 and not above 1";
  return failure(
      vm, "R0609",
      fmt::format("{} of {:.6g}: a fraction of the joint limits lies {}", what, value, range),
      part);
}

Answer<void> check_above_zero(Vm& vm, const char* what, double value, const char* unit,
                              CallPart part) {
  if (std::isfinite(value) && value > 0.0) return {};
  return failure(vm, "R0609",
                 fmt::format("{} of {} {}: the hand needs one above 0", what,
                             format_number(value * 1000.0), unit),
                 part);
}

Answer<void> check_tool_rates(Vm& vm, const MoveCall& call, const MoveSettings& settings) {
  if (settings.speed && !check_above_zero(vm, "a speed", *settings.speed, "mm/s", call.speed))
    return Failed{};
  if (!settings.accel) return {};
  return check_above_zero(vm, "an acceleration", *settings.accel, "mm/s^2", call.accel);
}

const Robot& model_of(Vm& vm, const MoveCall& call) {
  return call.model != nullptr ? *call.model : *Host::of(vm).cell().robot(call.robot).model;
}

const Robot* limiting_motors(Vm& vm, const MoveCall& call) {
  if (settings_of(vm).torques != TorqueCheck::kLimit) return nullptr;
  return Host::of(vm).cell().robot(call.robot).loaded.get();
}

Answer<void> check_duration(Vm& vm, double seconds, CallPart part) {
  if (std::isfinite(seconds) && seconds >= 0.0)
    return check_time_left(vm, "a motion", seconds, part);
  if (!std::isfinite(seconds)) return not_finite(vm, "the time", seconds, part);
  return failure(vm, "R0609", fmt::format("a move cannot take {} s", format_number(seconds)), part,
                 "time only runs forwards", "use a time of 0 s or more, or leave it out");
}

std::optional<IkTask> task_of(const Robot& robot, const PosC& target) {
  return armlet::task_of(robot, tool_pose(target));
}

Answer<Eigen::VectorXd> solve_target(Vm& vm, const MoveCall& call, const PosC& target,
                                     const Eigen::VectorXd& seed) {
  if (!check_arm(vm, call.robot)) return Failed{};
  const LimitCheck limits = call.moves ? settings_of(vm).limits : LimitCheck::kError;
  SolvedGoal goal = solve_goal(model_of(vm, call), tool_pose(target), seed, limits);
  if (!goal.ok()) return fail_move(vm, call, {.refusal = std::move(goal.refusal)});
  return std::move(goal.q);
}

namespace {

// What a call of a move says, and what the blocks around it say.
MoveCommand command_for(Vm& vm, const MoveCall& call, const MoveSettings& settings) {
  MoveCommand command = command_of(vm, call);
  command.time = settings.time;
  if (settings.T_flange_tool) command.T_flange_tool = settings.T_flange_tool;
  return command;
}

// Speed and acceleration are fractions of the limits of the joints.
Started move_joints(Vm& vm, const MoveCall& call, MoveTarget target, std::string planner,
                    const MoveSettings& settings) {
  MoveCommand command = command_for(vm, call, settings);
  command.target = std::move(target);
  command.planner = std::move(planner);
  if (settings.speed)
    command.speed = settings.speed;
  else if (settings.time)
    command.speed.reset();
  command.accel = settings.accel.value_or(command.accel);
  return run_move(vm, call, command);
}

// A straight line, or an arc over a position.
Started move_tool(Vm& vm, const MoveCall& call, const PosC& target, const MoveSettings& settings,
                  const std::optional<Eigen::Vector3d>& p_world_via) {
  const auto goal = in_world(vm, call, settings, target);
  if (!goal) return Failed{};
  MoveCommand command = command_for(vm, call, settings);
  command.target = LineTarget{.pose = tool_pose(*goal),
                              .p_world_via = p_world_via,
                              .tool_speed = settings.speed,
                              .tool_accel = settings.accel};
  return run_move(vm, call, command);
}

}  // namespace

Started move_to_joints(Vm& vm, MoveCall call, const Eigen::VectorXd& q, std::string planner,
                       const MoveSettings& settings) {
  if (settings_of(vm).path != nullptr) {
    const Eigen::VectorXd inside = clamped(vm, call, q);
    return collect_joints(vm, call, {}, {.q = inside, .planner = std::move(planner)}, settings);
  }
  return move_joints(vm, call, JointTarget{q}, std::move(planner), settings);
}

Started move_to_position(Vm& vm, MoveCall call, const PosC& target, const Eigen::VectorXd& near,
                         std::string planner, const MoveSettings& settings) {
  if (settings_of(vm).path != nullptr) {
    return collect_joints(vm, call, target, {.near = near, .planner = std::move(planner)},
                          settings);
  }
  const auto goal = in_world(vm, call, settings, target);
  if (!goal) return Failed{};
  return move_joints(vm, call, PoseTarget{tool_pose(*goal), near}, std::move(planner), settings);
}

Started move_on_line(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings) {
  if (settings_of(vm).path != nullptr) return collect(vm, call, target, settings);
  return move_tool(vm, call, target, settings, {});
}

Started move_on_arc(Vm& vm, MoveCall call, const PosC& via, const PosC& target,
                    const MoveSettings& settings) {
  const auto place = in_world(vm, call, settings, via);
  if (!place) return Failed{};
  const Eigen::Vector3d p_world_via = place->T.translation();
  call.way = "arc";
  if (settings_of(vm).path != nullptr) return collect(vm, call, target, settings, p_world_via);
  return move_tool(vm, call, target, settings, p_world_via);
}

}  // namespace armlet::bind
