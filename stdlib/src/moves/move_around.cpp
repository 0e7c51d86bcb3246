#include "moves/move_around.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/cell/collisions.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/format.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/format_vector.hpp"
#include "messages/library_messages.hpp"
#include "moves/limit_policy.hpp"
#include "moves/motion_collisions.hpp"
#include "moves/move_failures.hpp"
#include "moves/move_waiting.hpp"
#include "moves/trajectories.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

using Eigen::VectorXd;

// The joint values that reach the goal: the given ones first, then other solutions, nearest first.
std::vector<VectorXd> goals_of(const Robot& robot, const VectorXd& q0, const WayWanted& wanted) {
  constexpr double kSame = 1e-6;
  std::vector<VectorXd> goals = {wanted.goal};
  if (!wanted.any_branch) return goals;
  for (VectorXd& q : solve_ik_all(robot, forward(robot, wanted.goal), {.seed = q0})) {
    const bool known = std::ranges::any_of(
        goals, [&](const VectorXd& each) { return (each - q).cwiseAbs().maxCoeff() < kSame; });
    if (!known) goals.push_back(std::move(q));
  }
  return goals;
}

// Two bodies by name; all bodies of a link have the same name.
struct NamedPair {
  std::string first, second;
  double depth = 0.0;
  double share = 0.0;

  [[nodiscard]] std::string text() const { return fmt::format("{} and {}", first, second); }
};

std::vector<NamedPair> named(const Cell& cell, const std::vector<BlockingBodies>& blocking) {
  std::vector<NamedPair> all;
  for (const BlockingBodies& each : blocking) {
    NamedPair pair{body_text(cell, each.body), body_text(cell, each.other), each.depth, each.share};
    const auto same = std::ranges::find_if(all, [&](const NamedPair& known) {
      return known.first == pair.first && known.second == pair.second;
    });
    if (same == all.end()) {
      all.push_back(std::move(pair));
      continue;
    }
    same->depth = std::max(same->depth, pair.depth);
    same->share += pair.share;
  }
  return all;
}

Failure about(Vm& vm, const MoveCall& call) {
  Failure f;
  f.kind = "Collision";
  f.mark_parameter = kMarkCallee;
  f.place = call.place;
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  return f;
}

// R0643: the start or the goal of the path collides.
Failed fail_end(Vm& vm, const MoveCall& call, const WayAround& around, std::size_t goals) {
  const Cell& cell = Host::of(vm).cell();
  const bool at_start = around.way.status == WayStatus::kStartCollides;
  std::vector<NamedPair> pairs = named(cell, around.blocking);
  std::ranges::stable_sort(
      pairs, [](const NamedPair& a, const NamedPair& b) { return a.depth > b.depth; });
  Failure f = about(vm, call);
  f.headline = {
      row("R0643"),
      {pairs[0].first, pairs[0].second, at_start ? "where the robot stands" : "at the target"}};
  f.why = fmt::format("{} deep", format_mm(pairs[0].depth));
  for (std::size_t k = 1; k < pairs.size(); ++k)
    f.why += fmt::format("; {} too, {} deep", pairs[k].text(), format_mm(pairs[k].depth));
  if (goals > 1 && !at_start)
    f.why += fmt::format("; each of the {} solutions for this target collides", goals);
  if (!at_start) f.mark_parameter = call.target;
  f.fix = at_start ? "free the two before: move straight away from there with moveL"
                   : "choose another target, or another orientation there";
  return fail(vm, std::move(f));
}

// "link 3 of `arm` and "wall" (61 %), ...": shares of all collisions found during the path search.
std::string most_in_the_way(const Cell& cell, const std::vector<BlockingBodies>& blocking) {
  constexpr std::size_t kMost = 3;
  constexpr double kSeldom = 0.005;
  std::vector<NamedPair> pairs = named(cell, blocking);
  std::ranges::stable_sort(
      pairs, [](const NamedPair& a, const NamedPair& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t k = 0; k < std::min(pairs.size(), kMost) && pairs[k].share > kSeldom; ++k) {
    text +=
        fmt::format("{}{} ({:.0f} %)", k == 0 ? "" : ", ", pairs[k].text(), 100.0 * pairs[k].share);
  }
  return text;
}

Failed fail_search(Vm& vm, const MoveCall& call, const WayAround& around) {
  const Cell& cell = Host::of(vm).cell();
  Failure f = about(vm, call);
  const std::string blocking = most_in_the_way(cell, around.blocking);
  if (around.way.status == WayStatus::kCannotSearch) {
    f.headline = Headline(row("R0646"));
    f.why = fmt::format("it was built without OMPL, or its library was not found; in the way: {}",
                        blocking);
    f.fix = "go round through points in between";
    return fail(vm, std::move(f));
  }
  f.headline = {row("R0644"), {cell.robot(call.robot).name}};
  f.why = fmt::format("{} steps of the search; most often in the way: {}", around.way.iterations,
                      blocking);
  f.fix =
      "make room there, or go through a point in between; plan(..., iterations: 100000) "
      "searches longer";
  return fail(vm, std::move(f));
}

MotionNotes notes_of(const Robot& robot, const WayAround& around) {
  MotionNotes notes;
  const auto& points = around.way.points;
  for (std::size_t k = 1; k < points.size(); ++k) {
    notes.parts.push_back(
        {.what =
             fmt::format("around, to {}", format_point_mm(forward(robot, points[k]).translation())),
         .end = around.times[k - 1]});
  }
  return notes;
}

}  // namespace

Answer<WayAround> way_around(Vm& vm, const MoveCall& call, const WayWanted& wanted) try {
  const Cell& cell = Host::of(vm).cell();
  const CellRobot& state = cell.robot(call.robot);
  const std::shared_ptr<const Robot> model = call.model != nullptr ? call.model : state.model;
  WayAroundRequest request{.robot = call.robot,
                           .goals = goals_of(*model, state.q, wanted),
                           .model = model,
                           .time = wanted.move.time,
                           .search = wanted.search};
  if (!request.time) request.speed = wanted.move.speed.value_or(settings_of(vm).speed);
  const std::size_t goals = request.goals.size();
  const auto find_it = [&] { return find_way_around(cell, request); };
  WayAround around = find_it();
  keep_time(vm, call, request.time, around, find_it);
  switch (around.way.status) {
    case WayStatus::kFound:
      break;
    case WayStatus::kStartCollides:
    case WayStatus::kGoalCollides:
      return fail_end(vm, call, around, goals);
    default:
      return fail_search(vm, call, around);
  }
  if (around.ok()) {
    Host& host = Host::of(vm);
    host.note_way({.t_ns = host.now_ns(),
                   .robot = call.robot,
                   .model = model,
                   .motion = *around.motion.trajectory});
    return around;
  }
  if (!around.met.empty()) return fail_meeting(vm, call, around.met.front(), 0.0);
  if (!around.motion.outside.empty())
    return fail_swings_outside(vm, call, around.motion.outside.front());
  return fail_too_fast(vm, call, *around.motion.too_fast);
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error);
}

Started start_avoiding(Vm& vm, const MoveCall& call, Trajectory straight, const WayWanted& wanted) {
  const Cell& cell = Host::of(vm).cell();
  // Fingers have a prescribed path: no other path is searched, and a collision is refused.
  if (cell.robot(call.robot).on >= 0 || find_collisions(cell, call.robot, straight).empty()) {
    const double length = path_between_ends(vm, call, straight);
    return start_motion(vm, call, std::move(straight), length);
  }
  auto around = way_around(vm, call, wanted);
  if (!around) return Failed{};
  MotionNotes notes = notes_of(model_of(vm, call), *around);
  return start_motion(vm, call, *std::move(around->motion.trajectory), around->length,
                      std::move(notes));
}

}  // namespace armlet::bind
