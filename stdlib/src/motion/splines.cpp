#include "motion/splines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/kinematics/forward.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/trajectory/planner.hpp"
#include "moves/goals.hpp"
#include "moves/limit_policy.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

Answer<void> check_settings(Vm& vm, const MoveCall& call, std::size_t places,
                            const MoveSettings& settings, double accel) {
  if (places == 0)
    return failure(vm, "R0613", "a curve goes through one place or more, not 0", call.target);
  if (settings.time && !check_duration(vm, *settings.time, call.time)) return Failed{};
  if (settings.speed && !check_fraction(vm, "a speed", *settings.speed, call.speed))
    return Failed{};
  return check_fraction(vm, "an acceleration", accel, call.accel);
}

PathPlan plan(const Robot& robot, SplineMove move, bool only_positions) {
  PathPlan plan = plan_cartesian_spline(robot, move);
  if (!plan.fault || !only_positions) return plan;
  // The orientation cannot be kept everywhere: the tool rotates as little as necessary.
  move.task = IkTask::kPositionFirst;
  return plan_cartesian_spline(robot, move);
}

MotionNotes notes_of(const std::vector<PosC>& places, const PathPlan& plan) {
  MotionNotes notes;
  for (std::size_t k = 0; k < places.size(); ++k) {
    notes.parts.push_back({.what = fmt::format("to {}", format_point_mm(places[k].T.translation())),
                           .end = plan.times[k]});
  }
  return notes;
}

}  // namespace

std::optional<SplineKind> spline_called(std::string_view planner) {
  const auto row = std::ranges::find(planner_rows(), planner, &PlannerRow::name);
  return row == planner_rows().end() ? std::nullopt : row->in_space;
}

Started move_on_spline(Vm& vm, MoveCall call, const std::vector<PosC>& places, SplineKind kind,
                       const MoveSettings& settings) {
  const BlockSettings block = settings_of(vm);
  const double accel = settings.accel.value_or(block.accel);
  if (!check_settings(vm, call, places.size(), settings, accel)) return Failed{};
  choose_model(vm, call, settings, accel);
  const Robot& robot = model_of(vm, call);
  const Eigen::VectorXd q0 = Host::of(vm).cell().robot(call.robot).q;
  call.fixed_time = settings.time.has_value();
  SplineMove move{.q0 = q0, .kind = kind, .time = settings.time};
  if (!move.time) move.speed = settings.speed.value_or(block.speed);
  Goal at{forward(robot, q0), q0};
  std::vector<Eigen::VectorXd> starts;
  for (const PosC& place : places) {
    call.element = static_cast<int>(move.poses.size());
    starts.push_back(at.q);
    auto goal = goal_after(vm, call, place, at);
    if (!goal) return Failed{};
    at = *std::move(goal);
    move.poses.push_back(at.T_world_tool);
  }
  call.element = -1;
  const bool only_positions =
      std::ranges::none_of(places, [](const PosC& place) { return place.has_orientation; });
  const auto plan_it = [&] { return plan(model_of(vm, call), move, only_positions); };
  PathPlan curve = plan_it();
  if (!curve.ok() && !curve.motion.too_fast && lift_limits(vm, call)) {
    PathPlan beyond = plan_it();
    if (!beyond.fault) curve = std::move(beyond);
  }
  keep_time(vm, call, move.time, curve, plan_it);
  if (curve.fault) {
    const auto k = static_cast<std::size_t>(curve.point);
    call.element = curve.point;
    call.way = places.size() > 1 ? "curve to this place" : "curve";
    return fail_line(vm, call, starts[k], {move.poses[k], true}, *curve.fault);
  }
  if (!curve.motion.outside.empty()) return fail_swings_outside(vm, call, curve.motion.outside[0]);
  if (!curve.ok()) return fail_too_fast(vm, call, *curve.motion.too_fast);
  MotionNotes notes = notes_of(places, curve);
  return start_motion(vm, call, *std::move(curve.motion.trajectory), curve.length,
                      std::move(notes));
}

}  // namespace armlet::bind
