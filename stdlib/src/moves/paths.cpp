#include "moves/paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "messages/library_messages.hpp"
#include "moves/goals.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "values/bind.hpp"
#include "values/setting_words.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {
namespace {

using Eigen::VectorXd;

Failed fail_part(Vm& vm, std::string what, int parameter, std::string fix) {
  Failure f;
  f.headline = {row("R0635"), {std::move(what)}};
  f.mark_parameter = parameter;
  f.fix = std::move(fix);
  f.resource = robot_called({});
  f.moved = false;
  return fail(vm, std::move(f));
}

// The positions of a path one after another, each with the joint values at which its move begins.
class Corners {
 public:
  Corners(Vm& vm, const CollectedPath& path, std::shared_ptr<const Robot> model, const VectorXd& q0)
      : vm_(vm), path_(path), model_(std::move(model)), at_{forward(*model_, q0), q0} {}

  Answer<void> lay() {
    for (const CollectedMove& move : path_.moves) {
      starts_.push_back(at_.q);
      MoveCall call = move.call;
      call.model = model_;
      auto goal = move.joints ? joint_goal(call, move) : goal_after(vm_, call, move.target, at_);
      if (!goal) return Failed{};
      at_ = *std::move(goal);
      points_.push_back({.T_world_tool = at_.T_world_tool,
                         .q = move.joints ? std::optional(at_.q) : std::nullopt,
                         .p_world_via = move.p_world_via,
                         .blend = move.blend.value_or(path_.blend),
                         .tool_speed = move.speed ? move.speed : path_.speed,
                         .tool_accel = move.accel});
    }
    return {};
  }

  [[nodiscard]] const std::vector<PathPoint>& points() const { return points_; }
  [[nodiscard]] const VectorXd& start(int move) const {
    return starts_[static_cast<std::size_t>(move)];
  }
  // Whether no target has an orientation.
  [[nodiscard]] bool only_positions() const {
    return std::ranges::none_of(
        path_.moves, [](const CollectedMove& m) { return m.target.has_orientation && !m.joints; });
  }

 private:
  // The goal of a joint move.
  Answer<Goal> joint_goal(const MoveCall& call, const CollectedMove& move) {
    const VectorXd& near = move.joints->near.size() > 0 ? move.joints->near : at_.q;
    auto q = move.joints->q ? Answer<VectorXd>(*move.joints->q)
                            : solve_target(vm_, call, move.target, near);
    if (!q) return Failed{};
    const bool warns = settings_of(vm_).limits == LimitCheck::kWarn;
    if (const auto outside = limit_violations(*model_, *q); !outside.empty() && !warns)
      return fail_outside(vm_, call, *q, outside.front());
    return Goal{forward(*model_, *q), *std::move(q)};
  }

  Vm& vm_;
  const CollectedPath& path_;
  std::shared_ptr<const Robot> model_;
  Goal at_;
  std::vector<PathPoint> points_;
  std::vector<VectorXd> starts_;
};

// The call that messages about the time of the path refer to.
MoveCall timed_call(const CollectedPath& path, MoveCall whole) {
  whole.time = 0;
  whole.place = path.time_place;
  return whole;
}

// The failure, marked at the move that caused it.
Failed fail_path(Vm& vm, const CollectedPath& path, const MoveCall& whole, const Corners& corners,
                 const PathPlan& plan) {
  if (plan.fault) {
    MoveCall call = path.moves[static_cast<std::size_t>(plan.point)].call;
    call.model = whole.model;
    const PosC target{corners.points()[static_cast<std::size_t>(plan.point)].T_world_tool, true};
    return fail_line(vm, call, corners.start(plan.point), target, *plan.fault);
  }
  if (!plan.motion.outside.empty()) return fail_swings_outside(vm, whole, plan.motion.outside[0]);
  return fail_too_fast(vm, timed_call(path, whole), *plan.motion.too_fast);
}

MotionNotes notes_of(const CollectedPath& path, const Corners& corners, const PathPlan& plan) {
  MotionNotes notes;
  for (std::size_t k = 0; k < path.moves.size(); ++k) {
    const CollectedMove& move = path.moves[k];
    const Eigen::Isometry3d& T = corners.points()[k].T_world_tool;
    notes.parts.push_back(
        {.what = fmt::format("{} to {}", move.call.function, format_point_mm(T.translation())),
         .end = plan.times[k],
         .missed = plan.missed[k]});
  }
  return notes;
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
    return fail_part(vm, "a move with a tool of its own", kMarkCallee,
                     "write with (tool: ...) around the path");
  }
  if (!path.moves.empty() && path.moves.front().call.robot != call.robot) {
    return fail_part(vm,
                     fmt::format("a move of `{}` in a path of `{}`", cell.robot(call.robot).name,
                                 cell.robot(path.moves.front().call.robot).name),
                     kMarkCallee, "give each robot its own path, side by side in `parallel`");
  }
  if (!settings.blend) return {};
  return check_blend_length(vm, *settings.blend, kMarkCallee);
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

Answer<void> check_blend_length(Vm& vm, double blend, int parameter) {
  if (std::isfinite(blend) && blend >= 0.0) return {};
  return failure(
      vm, "R0609",
      fmt::format("a blend of {}: corners are rounded within 0 mm or more", format_mm(blend)),
      parameter);
}

Started make_path(Vm& vm, const CollectedPath& path) try {
  if (path.moves.empty()) return no_move();
  MoveCall whole{.function = "path", .robot = path.moves.front().call.robot, .target = -1};
  if (!check_idle(vm, whole.robot)) return Failed{};
  const BlockSettings block = settings_of(vm);
  choose_model(vm, whole, {}, block.accel);
  whole.fixed_time = path.time.has_value();
  const CellRobot& state = Host::of(vm).cell().robot(whole.robot);
  const std::shared_ptr<const Robot> model = whole.model != nullptr ? whole.model : state.model;
  Corners corners(vm, path, model, state.q);
  if (!corners.lay()) return Failed{};
  PathMove move{.q0 = state.q, .points = corners.points(), .time = path.time};
  if (!move.time) move.speed = block.speed;
  if (block.track == Track::kSlow) move.jerk = Jerk::kFree;
  if (move.jerk == Jerk::kLimited) move.motors = limiting_motors(vm, whole);
  double slowest = 0.0;  // total time of the moves with speeds of their own
  Eigen::Vector3d from = forward(*model, state.q).translation();
  for (const auto& point : move.points) {
    const Eigen::Vector3d to = point.T_world_tool.translation();
    slowest += least_time((to - from).norm(), point.tool_speed, point.tool_accel);
    from = to;
  }
  if (!check_time_left(vm, "a motion", slowest, kMarkCallee)) return Failed{};
  const auto plan_it = [&] { return plan_path(model_of(vm, whole), move); };
  PathPlan plan = plan_it();
  if (plan.fault && corners.only_positions()) {
    // The orientation cannot be kept everywhere: the tool rotates as little as necessary.
    move.task = IkTask::kPositionFirst;
    plan = plan_it();
  }
  if (!plan.ok() && !plan.motion.too_fast && lift_limits(vm, whole)) {
    PathPlan beyond = plan_it();
    if (!beyond.fault) plan = std::move(beyond);
  }
  keep_time(vm, timed_call(path, whole), move.time, plan, plan_it);
  if (!plan.ok()) return fail_path(vm, path, whole, corners, plan);
  MotionNotes notes = notes_of(path, corners, plan);
  return start_motion(vm, whole, *std::move(plan.motion.trajectory), plan.length, std::move(notes));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error);
}

}  // namespace armlet::bind
