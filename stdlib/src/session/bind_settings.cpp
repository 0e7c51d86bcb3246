// Settings of `with` (language reference, section 9). The checker calls "with{" before the block,
// one function for each setting, and "with}" on every way out.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "armlet/core/format.hpp"
#include "session/bind.hpp"
#include "session/settings.hpp"
#include "values/values.hpp"

namespace armlet::bind {

BlockSettings settings_of(Vm& vm) {
  const auto* settings = static_cast<const BlockSettings*>(vm.task_data().get());
  return settings != nullptr ? *settings : BlockSettings{};
}

void replace_settings(Vm& vm, BlockSettings settings) {
  vm.task_data() = std::make_shared<const BlockSettings>(std::move(settings));
}

void open_settings(Vm& vm) {
  BlockSettings inner = settings_of(vm);
  inner.outer = std::static_pointer_cast<const BlockSettings>(vm.task_data());
  replace_settings(vm, std::move(inner));
}

void close_settings(Vm& vm) {
  const auto inner = std::static_pointer_cast<const BlockSettings>(vm.task_data());
  vm.task_data() = inner->outer;
}

namespace {

template <double BlockSettings::*kMember>
Answer<void> set_fraction(Vm& vm, double value) {
  constexpr double kLeast = 1e-9;  // a turn would take years
  if (!(value >= kLeast && value <= 1.0)) {
    return failure(
        vm, "R0609",
        fmt::format("{:.6g} is no fraction of the joint limits: it must lie {}", value,
                    value > 0.0 && value < kLeast ? "from 1e-9 to 1" : "above 0 and not above 1"),
        0);
  }
  BlockSettings settings = settings_of(vm);
  settings.*kMember = value;
  replace_settings(vm, std::move(settings));
  return {};
}

struct TrackName {
  std::string_view name;
  Track track;
};
constexpr TrackName kTracks[] = {
    {"exact", Track::kExact}, {"slow", Track::kSlow}, {"damped", Track::kDamped}};

const TrackName* track_called(std::string_view name) {
  const auto* found = std::ranges::find(kTracks, name, &TrackName::name);
  return found != std::end(kTracks) ? found : nullptr;
}

Answer<void> set_track(Vm& vm, std::string_view name) {
  const TrackName* found = track_called(name);
  if (found == nullptr) {
    return failure(vm, "R0609",
                   fmt::format("lines cannot be tracked \"{}\": it is \"exact\", \"slow\" or "
                               "\"damped\"",
                               name),
                   0);
  }
  BlockSettings settings = settings_of(vm);
  settings.track = found->track;
  replace_settings(vm, std::move(settings));
  return {};
}

struct TorqueCheckName {
  std::string_view name;
  TorqueCheck check;
};
constexpr TorqueCheckName kTorqueChecks[] = {{"report", TorqueCheck::kReport},
                                             {"error", TorqueCheck::kError},
                                             {"ignore", TorqueCheck::kIgnore},
                                             {"limit", TorqueCheck::kLimit}};

const TorqueCheckName* torque_check_called(std::string_view name) {
  const auto* found = std::ranges::find(kTorqueChecks, name, &TorqueCheckName::name);
  return found != std::end(kTorqueChecks) ? found : nullptr;
}

Answer<void> set_torques(Vm& vm, std::string_view name) {
  const TorqueCheckName* found = torque_check_called(name);
  if (found == nullptr) {
    return failure(vm, "R0609",
                   fmt::format("torques cannot be checked \"{}\": it is \"report\", \"error\", "
                               "\"ignore\" or \"limit\"",
                               name),
                   0);
  }
  BlockSettings settings = settings_of(vm);
  settings.torques = found->check;
  replace_settings(vm, std::move(settings));
  return {};
}

struct CollisionCheckName {
  std::string_view name;
  CollisionCheck check;
};
constexpr CollisionCheckName kCollisionChecks[] = {{"report", CollisionCheck::kReport},
                                                   {"error", CollisionCheck::kError},
                                                   {"ignore", CollisionCheck::kIgnore}};

const CollisionCheckName* collision_check_called(std::string_view name) {
  const auto* found = std::ranges::find(kCollisionChecks, name, &CollisionCheckName::name);
  return found != std::end(kCollisionChecks) ? found : nullptr;
}

Answer<void> set_collisions(Vm& vm, std::string_view name) {
  const CollisionCheckName* found = collision_check_called(name);
  if (found == nullptr) {
    return failure(vm, "R0609",
                   fmt::format("collisions cannot be checked \"{}\": it is \"report\", \"error\" "
                               "or \"ignore\"",
                               name),
                   0);
  }
  BlockSettings settings = settings_of(vm);
  settings.collisions = found->check;
  replace_settings(vm, std::move(settings));
  return {};
}

void set_tool(Vm& vm, const PosC& tool) {
  BlockSettings settings = settings_of(vm);
  settings.T_flange_tool = tool.T;
  replace_settings(vm, std::move(settings));
}

void set_frame(Vm& vm, Frame frame) {
  BlockSettings settings = settings_of(vm);
  settings.frame = std::move(frame);
  replace_settings(vm, std::move(settings));
}
void set_frame_position(Vm& vm, const PosC& frame) { set_frame(vm, frame.T); }
void set_frame_object(Vm& vm, const ObjectRef& frame) { set_frame(vm, frame.name); }

// E0513.
void check_share(CheckCall& call, std::string_view what) {
  const auto constant = call.constant(0);
  if (!constant || (constant->real > 0.0 && constant->real <= 1.0)) return;
  Diagnostic d = make_diagnostic(
      "E0513", call.span(0),
      {std::string(what), "above 0 and at most 1", format_number(constant->real, 6)});
  d.why = "inside `with` it is a fraction of what the joints can do";
  call.report(std::move(d));
}
void check_track_setting(CheckCall& call) {
  const auto constant = call.constant(0);
  if (!constant || track_called(constant->text) != nullptr) return;
  call.report(
      make_diagnostic("E0513", call.span(0),
                      {"track", "\"exact\", \"slow\" or \"damped\"", '"' + constant->text + '"'}));
}
void check_torques_setting(CheckCall& call) {
  const auto constant = call.constant(0);
  if (!constant || torque_check_called(constant->text) != nullptr) return;
  call.report(make_diagnostic(
      "E0513", call.span(0),
      {"torques", "\"report\", \"error\", \"ignore\" or \"limit\"", '"' + constant->text + '"'}));
}
void check_collisions_setting(CheckCall& call) {
  const auto constant = call.constant(0);
  if (!constant || collision_check_called(constant->text) != nullptr) return;
  call.report(make_diagnostic(
      "E0513", call.span(0),
      {"collisions", "\"report\", \"error\" or \"ignore\"", '"' + constant->text + '"'}));
}
void check_speed_setting(CheckCall& call) { check_share(call, "the speed"); }
void check_accel_setting(CheckCall& call) { check_share(call, "the acceleration"); }

constexpr NativeFunction kSettingsFunctions[] = {
    def<open_settings>("with{()", "", "", {.in_path = true}),
    def<close_settings>("with}()", "", "", {.in_path = true}),
    def<set_fraction<&BlockSettings::speed>>(
        "with.speed(speed: double)",
        "Moves inside the block that give neither time nor speed run at this fraction of the joint "
        "limits.",
        "with (speed: 0.5) { moveJ(home()) }", {.check = check_speed_setting}),
    def<set_fraction<&BlockSettings::accel>>(
        "with.accel(accel: double)",
        "Moves inside the block keep to this fraction of the acceleration limits of the joints.",
        "with (accel: 0.5) { moveJ(home()) }", {.check = check_accel_setting}),
    def<set_tool>(
        "with.tool(tool: posC)",
        "Moves inside the block bring this point, seen from the flange, to their targets.",
        "with (tool: xyz(z: 20mm)) { moveJ(xyz(300mm, 200mm, 200mm)) }"),
    def<set_track>(
        "with.track(track: string)",
        "How moveL and moveCirc inside the block follow their way where joints would have to be "
        "fast, next to a singularity. \"exact\": the whole move is so slow that they can. "
        "\"slow\": it slows down only there. \"damped\": the joints stay slow and the hand "
        "leaves its way a little; the Move says how far, as its deviation.",
        "with (track: \"slow\") { moveL(xyz(300mm, 200mm, 200mm), speed: 200mm/s) }",
        {.check = check_track_setting}),
    def<set_torques>(
        "with.torques(torques: string)",
        "What becomes of a move inside the block that asks motors for more than the maxTorque of "
        "their joints. \"report\", as outside of any block: it is made, and advice says so. "
        "\"error\": it is refused before it starts. \"ignore\": it is made. \"limit\": moves "
        "without "
        "a time take as long as the motors need; those planned with Fastest use what the motors "
        "give "
        "instead of maxAccel.",
        "with (torques: \"error\") { moveJ(home()) }", {.check = check_torques_setting}),
    def<set_collisions>(
        "with.collisions(collisions: string)",
        "What becomes of a move inside the block in which the arm, or what it carries, would run "
        "into an object, another robot or itself. \"report\", as outside of any block: it is made, "
        "and advice says which bodies meet, when, where and how deep. \"error\": it is refused "
        "before it starts. \"ignore\": it is made.",
        "with (collisions: \"error\") { moveJ(home()) }", {.check = check_collisions_setting}),
    def<set_frame_position>(
        "with.frame(frame: posC)", "Targets in space inside the block are read in this frame.",
        "with (frame: xyz(z: 100mm)) { moveJ(xyz(300mm, 200mm, 50mm)) }", {.in_path = true}),
    def<set_frame_object>(
        "with.frame(frame: object)",
        "Targets in space inside the block are read in the frame of this object, wherever it "
        "is when the move begins.",
        "with (frame: object(\"cube\")) { moveJ(xyz(z: 60mm)) }", {.in_path = true}),
};

}  // namespace

std::span<const NativeFunction> settings_functions() { return kSettingsFunctions; }

}  // namespace armlet::bind
