#include "motion/motion_collisions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"

namespace armlet::bind {
namespace {

std::string place_text(const Eigen::Vector3d& p) {
  const auto mm = [](double x) { return std::round(1e3 * x) + 0.0; };
  return fmt::format("({:.0f}, {:.0f}, {:.0f}) mm", mm(p.x()), mm(p.y()), mm(p.z()));
}

std::string circumstances(const CellCollision& met, double duration) {
  std::string when = fmt::format("{} s after its start", format_number(met.t, 2));
  if (met.at_start) when = "from its start on";
  if (!met.at_start && met.at_end && met.t >= 0.995 * duration) when = "where it ends";
  return fmt::format("{}, up to {} deep, deepest at {}", when, format_mm(met.depth),
                     place_text(met.p_world));
}

// Passing higher helps what the hand has around the tool point; a link farther back moves
// otherwise than the hand.
std::string remedy(const CellCollision& met) {
  const bool at_hand = !met.body.object.empty() || is_hand(met.body.role);
  const bool is_object = !met.other.object.empty() && met.other.robot < 0;
  if (met.at_start) return "free the two before";
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

// Lines and curves are not planned around anything: their way is what was asked for.
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

Answer<void> check_collisions(Vm& vm, const MoveCall& call, const Trajectory& motion) {
  const BlockSettings settings = settings_of(vm);
  const CollisionCheck wanted = settings.avoid ? CollisionCheck::kError : settings.collisions;
  if (wanted == CollisionCheck::kIgnore || motion.duration() <= 0.0) return {};
  Host& host = Host::of(vm);
  const auto met = find_collisions(host.cell(), call.robot, motion);
  if (met.empty()) return {};
  if (wanted == CollisionCheck::kError)
    return fail_meeting(vm, call, met.front(), motion.duration());
  const void* code = (call.place.code() != nullptr ? call.place : place_of_call(vm)).code();
  for (const CellCollision& each : met) {
    const std::string pair =
        fmt::format("{}+{}", body_text(host.cell(), each.body), body_text(host.cell(), each.other));
    if (host.first_collision(code, pair))
      vm.advise(failure_of_meeting(vm, call, each, false, motion.duration()));
  }
  return {};
}

}  // namespace armlet::bind
