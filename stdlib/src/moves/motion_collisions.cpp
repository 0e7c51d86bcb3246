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
  f.mark = CallPart::callee();
  f.place = call.place;
  f.why = circumstances(met, duration);
  f.fix = remedy(met);
  return f;
}

// Lines and curves have a prescribed path, so no path around obstacles is searched for them.
bool has_a_way(const MoveCall& call) { return call.function != "moveJ"; }

}  // namespace

void advise_collision(Vm& vm, const MoveCall& call, const CellCollision& met, double duration) {
  Host& host = Host::of(vm);
  const void* code = (call.place.code() != nullptr ? call.place : place_of_call(vm)).code();
  const std::string pair =
      fmt::format("{}+{}", body_text(host.cell(), met.body), body_text(host.cell(), met.other));
  if (host.first_collision(code, pair))
    vm.advise(failure_of_meeting(vm, call, met, false, duration));
}

Failed fail_meeting(Vm& vm, const MoveCall& call, const CellCollision& met, double duration) {
  Failure f = failure_of_meeting(vm, call, met, true, duration);
  if (settings_of(vm).avoid && has_a_way(call) && !met.at_start && !met.at_end)
    f.fix += fmt::format("; only `moveJ` goes around by itself, `{}` has its way", call.function);
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  f.moved = false;
  return fail(vm, std::move(f));
}

Answer<std::vector<PossibleCollision>> check_finger_collisions(
    Vm& vm, const MoveCall& call, const Trajectory& motion, std::span<const MotionBeside> beside) {
  const BlockSettings settings = settings_of(vm);
  CollisionReport report = check_collisions(Host::of(vm).cell(), call.robot, motion,
                                            {.collisions = settings.collisions,
                                             .avoid = settings.avoid,
                                             .guarded = is_guarded(vm),
                                             .touching = call.function == kCloseHand},
                                            beside);
  if (report.is_refused) return fail_meeting(vm, call, report.certain.front(), motion.duration());
  for (const CellCollision& each : report.certain)
    advise_collision(vm, call, each, motion.duration());
  return std::move(report.possible);
}

void report_collisions(Vm& vm, const MoveCall& call, int motion,
                       const std::vector<PossibleCollision>& possible) {
  const Cell& cell = Host::of(vm).cell();
  const MotionReport& report = cell.report(motion);
  for (const CellCollision& met : confirmed_collisions(cell, motion, possible))
    advise_collision(vm, call, met, to_seconds(report.end_ns - report.start_ns));
}

}  // namespace armlet::bind
