#include "moves/moves.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/jerk_limited.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "messages/library_messages.hpp"
#include "moves/goals.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_around.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "moves/paths.hpp"
#include "moves/tracking.hpp"
#include "moves/trajectories.hpp"
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

Answer<void> check_fraction(Vm& vm, const char* what, double value, int parameter) {
  constexpr double kLeast = 1e-9;  // a revolution would take years
  if (value >= kLeast && value <= 1.0) return {};
  const char* range = value > 0.0 && value < kLeast ? "from 1e-9 to 1" : "above 0 and not above 1";
  return failure(
      vm, "R0609",
      fmt::format("{} of {:.6g}: a fraction of the joint limits lies {}", what, value, range),
      parameter);
}

Answer<void> check_above_zero(Vm& vm, const char* what, double value, const char* unit,
                              int parameter) {
  if (std::isfinite(value) && value > 0.0) return {};
  return failure(vm, "R0609",
                 fmt::format("{} of {} {}: the hand needs one above 0", what,
                             format_number(value * 1000.0), unit),
                 parameter);
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

Answer<void> check_duration(Vm& vm, double seconds, int parameter) {
  if (std::isfinite(seconds) && seconds >= 0.0)
    return check_time_left(vm, "a motion", seconds, parameter);
  if (!std::isfinite(seconds)) return not_finite(vm, "the time", seconds, parameter);
  return failure(vm, "R0609", fmt::format("a move cannot take {} s", format_number(seconds)),
                 parameter, "time only runs forwards",
                 "use a time of 0 s or more, or leave it out");
}

std::optional<IkTask> task_of(const Robot& robot, const PosC& target) {
  if (!target.has_orientation) return IkTask::kPositionFirst;
  return frame_task(robot, target.T);
}

Answer<Eigen::VectorXd> solve_target(Vm& vm, const MoveCall& call, const PosC& target,
                                     const Eigen::VectorXd& seed) {
  if (!check_arm(vm, call.robot)) return Failed{};
  const Robot& robot = model_of(vm, call);
  const std::optional<IkTask> task = task_of(robot, target);
  if (!task) return fail_tilted(vm, call, target);
  IkResult result = solve_ik(robot, target.T, {.seed = seed, .task = *task});
  if (result.status == IkStatus::kJointLimit && call.moves &&
      settings_of(vm).limits == LimitCheck::kWarn) {
    IkResult beyond =
        solve_ik(robot, target.T, {.seed = seed, .task = *task, .respect_limits = false});
    if (beyond.ok()) return wrap_near(robot, beyond.q, seed);
  }
  if (!result.ok()) return fail_unreachable(vm, call, target.T, result);
  return std::move(result.q);
}

bool starts_and_stops(const Trajectory& motion) {
  for (int i = 0; i < motion.n(); ++i) {
    if (motion.continuity(i, 1e-6) < 1) return false;
  }
  return true;
}

namespace {

// Whether this move continues from the present speeds of the robot: only moves as fast as the
// joints allow, with the planner "Syn" or "SCurve", for which an optimum exists from any state.
bool takes_over(Vm& vm, const MoveCall& call, std::string_view planner,
                const MoveSettings& settings) {
  const Cell& cell = Host::of(vm).cell();
  return cell.is_moving(call.robot) && cell.can_drive(call.robot) && !settings.time &&
         !call.classic && (planner == "Syn" || planner == "SCurve");
}

// Moves from the present speeds to rest at q within limits on speed, acceleration and jerk.
Started move_on_from_speed(Vm& vm, MoveCall call, const Eigen::VectorXd& q, double speed) {
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  const Robot& robot = model_of(vm, call);
  if (const auto outside = limit_violations(robot, q); !outside.empty())
    return fail_outside(vm, call, q, outside.front());
  std::vector<AxisLimits> limits = axis_limits(robot);
  std::vector<AxisState> from;
  for (int i = 0; i < robot.n(); ++i) {
    limits[static_cast<std::size_t>(i)].speed *= speed;
    from.push_back({.q = state.q[i], .v = state.qd[i], .a = state.qdd[i]});
  }
  std::vector<JerkProfile> profiles(from.size());
  const std::span<const double> to(q.data(), static_cast<std::size_t>(q.size()));
  const double duration = plan_jerk_limited(from, to, limits, profiles);
  MotionPlan plan = verify(robot, jerk_trajectory(from, to, profiles, duration));
  if (!plan.outside.empty()) return fail_swings_outside(vm, call, plan.outside.front());
  if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
  const double length = path_between_ends(vm, call, *plan.trajectory);
  call.fixed_time = true;  // it begins with a speed
  return start_motion(vm, call, *std::move(plan.trajectory), length);
}

// The part of a joint move that is the same for joint values and poses. The call must have its
// model.
Started move_joints(Vm& vm, MoveCall call, const Eigen::VectorXd& q, std::string planner,
                    const MoveSettings& settings) {
  Host& host = Host::of(vm);
  const CellRobot& state = host.cell().robot(call.robot);
  if (q.size() == state.model->n() && !limit_violations(*state.model, q).empty())
    lift_limits(vm, call, q);
  const Robot& robot = model_of(vm, call);
  if (q.size() != robot.n()) return fail_joint_count(vm, call, static_cast<int>(q.size()));
  if (settings.speed && !check_fraction(vm, "a speed", *settings.speed, call.speed))
    return Failed{};
  if (!host.planners().has(planner)) return fail_planner(vm, call, planner);
  if (Host::of(vm).cell().is_moving(call.robot)) {
    return move_on_from_speed(vm, call, q, settings.speed.value_or(settings_of(vm).speed));
  }
  JointMove move{.q0 = state.q,
                 .q1 = q,
                 .planner = std::move(planner),
                 .time = settings.time,
                 .speed = settings.speed,
                 .enforce_limits = !may_be_too_fast(vm, call),
                 .motors = limiting_motors(vm, call)};
  if (!move.time && !move.speed) move.speed = settings_of(vm).speed;
  MotionPlan plan = plan_joint_move(host.planners(), robot, move);
  if (!plan.trajectory && plan.too_fast) {
    if (const auto time = lengthened(vm, call, *plan.too_fast)) {
      move.time = time;
      plan = plan_joint_move(host.planners(), robot, move);
    }
  }
  if (!plan.outside.empty()) return fail_outside(vm, call, q, plan.outside.front());
  if (!plan.trajectory) return fail_too_fast(vm, call, *plan.too_fast);
  if (plan.too_fast) advise_too_fast(vm, call, *plan.too_fast);
  if (!starts_and_stops(*plan.trajectory)) return fail_no_ramps(vm, call, move.planner);
  if (settings_of(vm).avoid) {
    return start_avoiding(vm, call, *std::move(plan.trajectory),
                          {.goal = q, .any_branch = call.any_branch, .move = settings});
  }
  const Eigen::Vector3d from = forward(robot, state.q).translation();
  const Eigen::Vector3d to = forward(robot, q).translation();
  return start_motion(vm, call, *std::move(plan.trajectory), (to - from).norm());
}

// Checks that need no inverse kinematics.
Answer<void> prepare_joints(Vm& vm, MoveCall& call, std::string_view planner,
                            const MoveSettings& settings) {
  if (!takes_over(vm, call, planner, settings) && !check_idle(vm, call.robot)) return Failed{};
  if (settings.time && !check_duration(vm, *settings.time, call.time)) return Failed{};
  const double accel = settings.accel.value_or(settings_of(vm).accel);
  if (!check_fraction(vm, "an acceleration", accel, call.accel)) return Failed{};
  choose_model(vm, call, settings, accel);
  call.fixed_time = settings.time.has_value();
  return {};
}

}  // namespace

Started move_to_joints(Vm& vm, MoveCall call, const Eigen::VectorXd& given, std::string planner,
                       const MoveSettings& settings) {
  const Eigen::VectorXd q = clamped(vm, call, given);
  if (settings_of(vm).path != nullptr)
    return collect_joints(vm, call, {}, {.q = q, .planner = std::move(planner)}, settings);
  if (!prepare_joints(vm, call, planner, settings)) return Failed{};
  return move_joints(vm, call, q, std::move(planner), settings);
}

Started move_to_position(Vm& vm, MoveCall call, const PosC& target, const Eigen::VectorXd& near,
                         std::string planner, const MoveSettings& settings) {
  if (settings_of(vm).path != nullptr) {
    return collect_joints(vm, call, target, {.near = near, .planner = std::move(planner)},
                          settings);
  }
  if (!prepare_joints(vm, call, planner, settings)) return Failed{};
  const auto goal = in_world(vm, call, settings, target);
  if (!goal) return Failed{};
  const Eigen::VectorXd& present = Host::of(vm).cell().robot(call.robot).q;
  const auto q = solve_target(vm, call, *goal, near.size() > 0 ? near : present);
  if (!q) return Failed{};
  call.any_branch = near.size() == 0;
  return move_joints(vm, call, *q, std::move(planner), settings);
}

namespace {

// Plans the line, slower or within the limits if the blocks around the call say so.
TrackedLine plan_within_policy(Vm& vm, MoveCall& call, LineMove move,
                               const std::optional<Eigen::Vector3d>& p_world_via,
                               bool only_position) {
  const Track track = settings_of(vm).track;
  const auto plan = [&] {
    return plan_tracked(model_of(vm, call), move, p_world_via, track, only_position);
  };
  TrackedLine line = plan();
  const bool leaves = line.fault || !line.motion.outside.empty();
  if (leaves && lift_limits(vm, call)) {
    TrackedLine beyond = plan();
    if (beyond.motion.ok()) return beyond;
  }
  if (!line.fault && !line.motion.ok() && line.motion.too_fast && move.time) {
    if (const auto time = lengthened(vm, call, *line.motion.too_fast)) {
      move.time = time;
      line = plan();
    }
  }
  return line;
}

// A straight line, or an arc over a position.
Started move_tool(Vm& vm, MoveCall call, const PosC& written, const MoveSettings& settings,
                  const std::optional<Eigen::Vector3d>& p_world_via) try {
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  if (!check_arm(vm, call.robot) || !check_idle(vm, call.robot)) return Failed{};
  if (settings.time && !check_duration(vm, *settings.time, call.time)) return Failed{};
  if (!check_tool_rates(vm, call, settings)) return Failed{};
  const BlockSettings block = settings_of(vm);
  choose_model(vm, call, settings, block.accel);
  call.fixed_time = settings.time.has_value();
  const Robot& robot = model_of(vm, call);
  const auto target = in_world(vm, call, settings, written);
  if (!target) return Failed{};
  const std::optional<IkTask> task = task_of(robot, *target);
  if (!task) return fail_tilted(vm, call, *target);
  const Eigen::Isometry3d T_world_tool = forward(robot, state.q);
  const double distance = (target->T.translation() - T_world_tool.translation()).norm();
  if (settings.time && *settings.time == 0.0 && distance > 0.0)
    return fail_no_time(vm, call, distance);
  const double least = least_time(distance, settings.speed, settings.accel);
  const int slow = settings.speed ? call.speed : call.accel;
  if (!settings.time && !check_time_left(vm, "a motion", least, slow)) return Failed{};
  LineMove move{.q0 = state.q,
                .T_world_goal = target->T,
                .task = *task,
                .time = settings.time,
                .tool_speed = settings.speed,
                .tool_accel = settings.accel,
                .speed = block.speed,
                .enforce_limits = !may_be_too_fast(vm, call)};
  if (block.track != Track::kExact) {
    const auto goal = goal_after(vm, call, *target, {T_world_tool, state.q});
    if (!goal) return Failed{};
    move.T_world_goal = goal->T_world_tool;
  }
  TrackedLine plan = plan_within_policy(vm, call, move, p_world_via, !target->has_orientation);
  if (plan.fault) return fail_line(vm, call, state.q, *target, *plan.fault);
  if (!plan.motion.outside.empty())
    return fail_outside(vm, call, state.q, plan.motion.outside.front());
  if (!plan.motion.trajectory) return fail_too_fast(vm, call, *plan.motion.too_fast);
  if (plan.motion.too_fast) advise_too_fast(vm, call, *plan.motion.too_fast);
  return start_motion(vm, call, *std::move(plan.motion.trajectory), plan.length,
                      {.deviation = plan.deviation, .turn = plan.turn});
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error);
}

}  // namespace

Started move_on_line(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings) {
  if (settings_of(vm).path != nullptr) return collect(vm, call, target, settings);
  return move_tool(vm, std::move(call), target, settings, {});
}

Started move_on_arc(Vm& vm, MoveCall call, const PosC& via, const PosC& target,
                    const MoveSettings& settings) {
  const auto place = in_world(vm, call, settings, via);
  if (!place) return Failed{};
  const Eigen::Vector3d p_world_via = place->T.translation();
  call.way = "arc";
  if (settings_of(vm).path != nullptr) return collect(vm, call, target, settings, p_world_via);
  return move_tool(vm, std::move(call), target, settings, p_world_via);
}

}  // namespace armlet::bind
