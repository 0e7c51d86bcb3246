#include "motion/splines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/math/format_vector.hpp"
#include "armlet/trajectory/planner.hpp"
#include "moves/move_waiting.hpp"
#include "moves/move_words.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

std::vector<std::string> labels_of(const std::vector<PosC>& places) {
  std::vector<std::string> labels;
  for (const PosC& place : places)
    labels.push_back(fmt::format("to {}", format_point_mm(place.T.translation())));
  return labels;
}

}  // namespace

std::optional<SplineKind> spline_called(std::string_view planner) {
  const auto row = std::ranges::find(planner_rows(), planner, &PlannerRow::name);
  return row == planner_rows().end() ? std::nullopt : row->in_space;
}

Started move_on_spline(Vm& vm, MoveCall call, const std::vector<PosC>& places, SplineKind kind,
                       const MoveSettings& settings) {
  if (places.empty())
    return failure(vm, "R0613", "a curve goes through one place or more, not 0", call.target);
  MoveCommand command = command_of(vm, call);
  command.time = settings.time;
  if (settings.speed || settings.time) command.speed = settings.speed;
  command.accel = settings.accel.value_or(command.accel);
  CurveTarget curve{.kind = kind};
  for (const PosC& place : places) curve.poses.push_back(tool_pose(place));
  command.target = std::move(curve);
  const auto call_of = [&](const MoveReport& report) {
    MoveCall at = call;
    at.element = report.target;
    at.way = places.size() > 1 ? "curve to this place" : "curve";
    return at;
  };
  return run_move(
      vm, call, command,
      {.labels = [&](const MoveReport&) { return labels_of(places); }, .call_of = call_of});
}

}  // namespace armlet::bind
