// path (blend: 30mm) { ... } (language reference, 13.3). The checker calls the function of
// BlockEvent::kPathBegins before the block, one for each setting, kPathMoves at its end, and
// kPathEnds at every exit.

#include <utility>

#include "moves/paths.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/settings.hpp"

namespace armlet::bind {
namespace {

void enter(Vm& vm) {
  open_settings(vm);
  BlockSettings settings = settings_of(vm);
  settings.path = std::make_shared<CollectedPath>();
  replace_settings(vm, std::move(settings));
}

// Ends the collection: from here on moves are executed again, also those of watches.
Started make_moves(Vm& vm) {
  BlockSettings settings = settings_of(vm);
  const std::shared_ptr<CollectedPath> path = std::exchange(settings.path, nullptr);
  replace_settings(vm, std::move(settings));
  return make_path(vm, *path);
}

Answer<void> set_blend(Vm& vm, double blend) {
  if (!check_blend_length(vm, blend, at("blend"))) return Failed{};
  settings_of(vm).path->blend = blend;
  return {};
}

Answer<void> set_speed(Vm& vm, double speed) {
  if (!check_above_zero(vm, "a speed", speed, "mm/s", at("speed"))) return Failed{};
  settings_of(vm).path->speed = speed;
  return {};
}

Answer<void> set_time(Vm& vm, double time) {
  if (!check_duration(vm, time, at("time"))) return Failed{};
  CollectedPath& path = *settings_of(vm).path;
  path.time = time;
  path.time_place = place_of_call(vm);
  return {};
}

void check_blend_setting(CheckCall& call) { check_blend(call, at("blend")); }
void check_time_setting(CheckCall& call) { check_duration(call, at("time")); }

constexpr NativeFunction kPathFunctions[] = {
    def<enter>("path()", "", "", {.event = BlockEvent::kPathBegins}),
    def<close_settings>("path()", "", "", {.event = BlockEvent::kPathEnds}),
    def<make_moves>("path() -> Move", "", "", {.pauses = true, .event = BlockEvent::kPathMoves}),
    def<set_blend>(
        "path.blend(blend: length)",
        "Moves inside the block are planned and made as one motion, and its corners are "
        "rounded: up to this far before and after a target, and at most half of either move, "
        "the hand leaves its line. Moves with a blend of their own keep it; with 0 mm the "
        "hand stops there.",
        "moveJ(xyz(300mm, 200mm, 150mm)); path (blend: 20mm) { moveL(xyz(300mm, 0mm, "
        "150mm)); moveL(xyz(400mm, 0mm, 150mm)) }",
        {.check = check_blend_setting}),
    def<set_speed>("path.speed(speed: speed)",
                   "The highest speed of the hand in moves that have none of their own.",
                   "moveJ(xyz(300mm, 200mm, 150mm)); path (speed: 200mm/s) { moveL(xyz(300mm, 0mm, "
                   "150mm)); moveL(xyz(400mm, 0mm, 150mm)) }"),
    def<set_time>(
        "path.time(time: time)",
        "How long the whole path takes; without it, it is made as fast as the joints and the "
        "speeds of its moves allow.",
        "moveJ(xyz(300mm, 200mm, 150mm)); path (blend: 20mm, time: 4s) { moveL(xyz(300mm, "
        "0mm, 150mm)); moveL(xyz(400mm, 0mm, 150mm)) }",
        {.check = check_time_setting}),
};

}  // namespace

std::span<const NativeFunction> path_functions() { return kPathFunctions; }

}  // namespace armlet::bind
