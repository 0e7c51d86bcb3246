#include "moves/paths.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "armlet/core/format.hpp"
#include "armlet/math/format_vector.hpp"
#include "messages/library_messages.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "moves/move_words.hpp"
#include "values/bind.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

Failed fail_part(Vm& vm, std::string what, CallPart part, std::string fix) {
  Failure f;
  f.headline = {row("R0635"), {std::move(what)}};
  f.mark = part;
  f.fix = std::move(fix);
  f.resource = robot_called({});
  f.moved = false;
  return fail(vm, std::move(f));
}

// The call that messages about the time of the path refer to.
MoveCall timed_call(const CollectedPath& path, MoveCall whole) {
  whole.time = at("time");
  whole.place = path.time_place;
  return whole;
}

PathTarget target_of(const CollectedPath& path) {
  PathTarget target;
  for (const CollectedMove& move : path.moves) {
    PathStep step{.pose = tool_pose(move.target),
                  .moves_joints = move.joints.has_value(),
                  .p_world_via = move.p_world_via,
                  .blend = move.blend.value_or(path.blend),
                  .tool_speed = move.speed ? move.speed : path.speed,
                  .tool_accel = move.accel};
    if (move.joints) {
      step.q = move.joints->q;
      step.near = move.joints->near;
    }
    target.steps.push_back(std::move(step));
  }
  return target;
}

std::vector<std::string> labels_of(const CollectedPath& path, const MoveReport& report) {
  std::vector<std::string> labels;
  for (std::size_t k = 0; k < path.moves.size(); ++k) {
    labels.push_back(fmt::format("{} to {}", path.moves[k].call.function,
                                 format_point_mm(report.planned.T_world_targets[k].translation())));
  }
  return labels;
}

// Fails for settings that a move in a path cannot have.
Answer<void> check_belongs(Vm& vm, const MoveCall& call, const MoveSettings& settings) {
  const CollectedPath& path = *settings_of(vm).path;
  const Cell& cell = Host::of(vm).cell();
  if (settings.time) {
    return fail_part(vm, "a move with a time of its own", call.time,
                     "give the whole path a time, path (time: ...)");
  }
  if (settings.T_flange_tool) {
    return fail_part(vm, "a move with a tool of its own", CallPart::callee(),
                     "write with (tool: ...) around the path");
  }
  if (!path.moves.empty() && path.moves.front().call.robot != call.robot) {
    return fail_part(vm,
                     fmt::format("a move of `{}` in a path of `{}`", cell.robot(call.robot).name,
                                 cell.robot(path.moves.front().call.robot).name),
                     CallPart::callee(),
                     "give each robot its own path, side by side in `parallel`");
  }
  if (!settings.blend) return {};
  return check_blend_length(vm, *settings.blend, CallPart::callee());
}

std::unique_ptr<Waiting> add(Vm& vm, CollectedMove move) {
  move.call.place = place_of_call(vm);
  settings_of(vm).path->moves.push_back(std::move(move));
  return no_move();
}

}  // namespace

Started collect(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings,
                std::optional<Eigen::Vector3d> p_world_via) {
  if (!check_belongs(vm, call, settings) || !check_tool_rates(vm, call, settings)) return Failed{};
  const auto place = in_world(vm, call, settings, target);
  if (!place) return Failed{};
  return add(vm, {.call = std::move(call),
                  .target = *place,
                  .p_world_via = p_world_via,
                  .blend = settings.blend,
                  .speed = settings.speed,
                  .accel = settings.accel});
}

Started collect_joints(Vm& vm, MoveCall call, const PosC& target, JointGoal goal,
                       const MoveSettings& settings) {
  if (!check_belongs(vm, call, settings)) return Failed{};
  if (settings.speed || settings.accel) {
    return fail_part(vm, "a move of the joints with limits of its own",
                     settings.speed ? call.speed : call.accel,
                     "write with (speed: ..., accel: ...) around the path");
  }
  if (goal.planner != kPathPlanner) {
    return fail_part(vm, fmt::format("a move with the planner \"{}\"", goal.planner), call.planner,
                     "leave it out: the speed along a path is planned as a whole");
  }
  const int n = model_of(vm, call).n();
  if (goal.q && goal.q->size() != n)
    return fail_joint_count(vm, call, static_cast<int>(goal.q->size()));
  const auto place = goal.q ? Answer<PosC>(target) : in_world(vm, call, settings, target);
  if (!place) return Failed{};
  return add(vm, {.call = std::move(call),
                  .target = *place,
                  .joints = std::move(goal),
                  .blend = settings.blend});
}

Answer<void> check_blend_length(Vm& vm, double blend, CallPart part) {
  if (std::isfinite(blend) && blend >= 0.0) return {};
  return failure(
      vm, "R0609",
      fmt::format("a blend of {}: corners are rounded within 0 mm or more", format_mm(blend)),
      part);
}

Started make_path(Vm& vm, const CollectedPath& path) {
  if (path.moves.empty()) return no_move();
  MoveCall whole{.function = "path", .robot = path.moves.front().call.robot, .target = {}};
  MoveCommand command = command_of(vm, whole);
  command.target = target_of(path);
  command.time = path.time;
  if (path.time) command.speed.reset();
  const auto call_of = [&](const MoveReport& report) {
    return report.target < 0 ? whole : path.moves[static_cast<std::size_t>(report.target)].call;
  };
  return run_move(vm, whole, command,
                  {.labels = [&](const MoveReport& report) { return labels_of(path, report); },
                   .call_of = call_of,
                   .timed = timed_call(path, whole)});
}

}  // namespace armlet::bind
