#include "moves/motion_collisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

std::string place_text(const Eigen::Vector3d& p) {
  const auto mm = [](double x) { return std::round(1e3 * x) + 0.0; };
  return fmt::format("({:.0f}, {:.0f}, {:.0f}) mm", mm(p.x()), mm(p.y()), mm(p.z()));
}

// The depth rounded to 0.1 mm in the safe direction: an upper bound up, a lower bound down. Never 0
// for a lower bound.
std::string depth_text(const CellCollision& met) {
  constexpr double kTenth = 1e-4, kSame = 0.02;
  const double tenths = met.depth / kTenth;
  return format_mm(kTenth * (met.at_least ? std::max(std::floor(tenths + kSame), 1.0)
                                          : std::ceil(tenths - kSame)));
}

std::string circumstances(const CellCollision& met, double duration) {
  std::string when = fmt::format("{} s after its start", format_number(met.t, 2));
  if (met.at_start) when = "from its start on";
  if (!met.at_start && met.at_end && met.t >= 0.995 * duration) when = "where it ends";
  return fmt::format("{}, {} {} deep, deepest at {}", when, met.at_least ? "at least" : "up to",
                     depth_text(met), place_text(met.p_world));
}

// A higher path helps only for bodies near the tool point; links farther back move differently from
// the tool.
std::string remedy(const CellCollision& met) {
  const bool at_hand = !met.body.object.empty() || is_hand(met.body.role);
  const bool is_object = !met.other.object.empty() && met.other.robot < 0;
  if (met.at_start) return "move the two apart before this move";
  if (at_hand && is_object && met.higher > 0.0) {
    const double mm = std::ceil(1e3 * met.higher - 0.1);
    return fmt::format("{} at least {:.0f} mm higher", met.at_end ? "end it" : "pass there", mm);
  }
  return met.at_end ? "choose another target" : "go round through a point in between";
}

Failure failure_of_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, bool is_error,
                           double duration) {
  const Cell& cell = Host::of(vm).cell();
  std::string first = body_text(cell, met.body), second = body_text(cell, met.other);
  Failure f;
  if (is_error) {
    f.headline = {row("R0614"), {std::move(first), std::move(second)}};
  } else {
    f.headline = {row("W0711"), {std::move(first), std::move(second)}};
  }
  f.mark_parameter = kMarkCallee;
  f.place = call.place;
  f.why = circumstances(met, duration);
  f.fix = remedy(met);
  return f;
}

// Whether the tool or its payload presses into an object, which causes a contact force.
bool is_felt(const Cell& cell, const CellCollision& met) {
  return feels(cell, met.body) && !met.other.object.empty();
}

void advise(Vm& vm, const MoveCall& call, const CellCollision& met, double duration) {
  Host& host = Host::of(vm);
  const void* code = (call.place.code() != nullptr ? call.place : place_of_call(vm)).code();
  const std::string pair =
      fmt::format("{}+{}", body_text(host.cell(), met.body), body_text(host.cell(), met.other));
  if (host.first_collision(code, pair))
    vm.advise(failure_of_meeting(vm, call, met, false, duration));
}

// Whether a robot started a motion with a number above `last` at t_ns or before.
bool has_started(const Cell& cell, int robot, int last, std::int64_t t_ns) {
  for (int motion = last + 1; motion <= cell.robot(robot).motion_id; ++motion) {
    const MotionReport& report = cell.report(motion);
    if (report.robot == robot) return report.start_ns <= t_ns;
  }
  return false;
}

// Lines and curves have a prescribed path, so no path around obstacles is searched for them.
bool has_a_way(const MoveCall& call) { return call.function != "moveJ"; }

}  // namespace

Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration) {
  Failure f = failure_of_meeting(vm, call, met, true, duration);
  if (settings_of(vm).avoid && has_a_way(call) && !met.at_start && !met.at_end)
    f.fix += fmt::format("; only `moveJ` goes around by itself, `{}` has its way", call.function);
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  return fail(vm, std::move(f));
}

Answer<std::vector<PossibleCollision>> check_collisions(Vm& vm, const MoveCall& call,
                                                        const Trajectory& motion,
                                                        std::span<const MotionBeside> beside) {
  const BlockSettings settings = settings_of(vm);
  const CollisionCheck wanted = settings.avoid ? CollisionCheck::kError : settings.collisions;
  if (wanted == CollisionCheck::kIgnore || motion.duration() <= 0.0)
    return std::vector<PossibleCollision>{};
  Host& host = Host::of(vm);
  auto met = find_collisions(host.cell(), call.robot, motion, beside);
  // Closing fingers are meant to touch; their contact force is checked instead (R0637).
  if (call.function == kCloseHand)
    std::erase_if(met, [](const CellCollision& each) { return !each.other.object.empty(); });
  const bool guarded = is_guarded(vm);
  if (guarded && wanted == CollisionCheck::kError)
    std::erase_if(met, [&](const CellCollision& each) { return is_felt(host.cell(), each); });
  std::vector<PossibleCollision> possible;
  if (met.empty()) return possible;
  if (wanted == CollisionCheck::kError)
    return fail_meeting(vm, call, met.front(), motion.duration());
  for (CellCollision& each : met) {
    const int other = each.other.robot;
    const bool is_other = other >= 0 && other != call.robot;
    const bool is_known =
        is_other && std::ranges::find(beside, other, &MotionBeside::robot) != beside.end();
    const bool stands = is_other && !is_known && !host.cell().is_moving(other);
    if (each.at_start || !(guarded || stands)) {
      advise(vm, call, each, motion.duration());
      continue;
    }
    std::optional<int> last;
    if (is_other && !is_known) last = host.cell().robot(other).motion_id;
    possible.push_back({.met = std::move(each), .guarded = guarded, .last = last});
  }
  return possible;
}

void report_collisions(Vm& vm, const MoveCall& call, int motion,
                       const std::vector<PossibleCollision>& possible) {
  constexpr double kPressed = 0.010;  // m: a deeper contact is not a touch
  const Cell& cell = Host::of(vm).cell();
  const MotionReport& report = cell.report(motion);
  const double duration = to_seconds(report.end_ns - report.start_ns);
  for (const PossibleCollision& each : possible) {
    const CellCollision& met = each.met;
    if (report.state == MotionState::kStopped && met.t >= duration) continue;
    if (each.last && has_started(cell, met.other.robot, *each.last, report.start_ns + to_ns(met.t)))
      continue;
    if (each.guarded && is_felt(cell, met) &&
        -distance_between(cell, met.body, met.other, Carried::kLeftOut) <= kPressed)
      continue;
    advise(vm, call, met, duration);
  }
}

}  // namespace armlet::bind
