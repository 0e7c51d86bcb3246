// Settings of `with` (language reference, section 9). The checker calls the function of
// BlockEvent::kWithBegins before the block, one for each setting, and kWithEnds at every exit.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "armlet/core/format.hpp"
#include "motion/setting_choices.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/settings.hpp"
#include "values/values.hpp"

namespace armlet::bind {

namespace {

template <double BlockSettings::*kMember>
Answer<void> set_fraction(Vm& vm, double value) {
  constexpr double kLeast = 1e-9;  // a revolution would take years
  if (!(value >= kLeast && value <= 1.0)) {
    return failure(
        vm, "R0609",
        fmt::format("{:.6g} is no fraction of the joint limits: it must lie {}", value,
                    value > 0.0 && value < kLeast ? "from 1e-9 to 1" : "above 0 and not above 1"),
        CallPart::first());
  }
  BlockSettings settings = settings_of(vm);
  settings.*kMember = value;
  replace_settings(vm, std::move(settings));
  return {};
}

// A setting that is one of a few names.
//
// cannot  beginning of the message about another name.
template <class T, std::size_t N>
struct NamedChoices {
  std::string_view setting;
  std::string_view cannot;
  T BlockSettings::*member;
  std::pair<std::string_view, T> choices[N];

  [[nodiscard]] const T* called(std::string_view name) const {
    const auto* found = std::ranges::find(choices, name, &std::pair<std::string_view, T>::first);
    return found != std::end(choices) ? &found->second : nullptr;
  }
  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> out;
    for (const auto& [name, unused] : choices) out.push_back(name);
    return out;
  }
};

constexpr NamedChoices<Track, 3> kTrack{
    "track",
    "lines cannot be tracked",
    &BlockSettings::track,
    {{"exact", Track::kExact}, {"slow", Track::kSlow}, {"damped", Track::kDamped}}};
constexpr NamedChoices<TorqueCheck, 4> kTorques{"torques",
                                                "torques cannot be checked",
                                                &BlockSettings::torques,
                                                {{"report", TorqueCheck::kReport},
                                                 {"error", TorqueCheck::kError},
                                                 {"ignore", TorqueCheck::kIgnore},
                                                 {"limit", TorqueCheck::kLimit}}};
constexpr NamedChoices<CollisionCheck, 3> kCollisions{"collisions",
                                                      "collisions cannot be checked",
                                                      &BlockSettings::collisions,
                                                      {{"report", CollisionCheck::kReport},
                                                       {"error", CollisionCheck::kError},
                                                       {"ignore", CollisionCheck::kIgnore}}};

constexpr NamedChoices<LimitCheck, 3> kJointLimits{
    "limits",
    "limits cannot be treated as",
    &BlockSettings::limits,
    {{"error", LimitCheck::kError}, {"clamp", LimitCheck::kClamp}, {"warn", LimitCheck::kWarn}}};

template <const auto& kSetting>
void add_choices(std::string_view setting, std::vector<std::string>& out) {
  if (kSetting.setting != setting) return;
  for (const auto& [name, unused] : kSetting.choices) out.emplace_back(name);
}

template <const auto& kSetting>
Answer<void> set_choice(Vm& vm, std::string_view name) {
  const auto* choice = kSetting.called(name);
  if (choice == nullptr) {
    return failure(
        vm, "R0609",
        fmt::format("{} \"{}\": it is {}", kSetting.cannot, name, choice_of(kSetting.names())),
        CallPart::first());
  }
  BlockSettings settings = settings_of(vm);
  settings.*kSetting.member = *choice;
  replace_settings(vm, std::move(settings));
  return {};
}

void set_tool(Vm& vm, const PosC& tool) {
  BlockSettings settings = settings_of(vm);
  settings.T_flange_tool = tool.T;
  replace_settings(vm, std::move(settings));
}

void set_avoid(Vm& vm, bool avoid) {
  BlockSettings settings = settings_of(vm);
  settings.avoid = avoid;
  replace_settings(vm, std::move(settings));
}

void set_frame(Vm& vm, Frame frame) {
  BlockSettings settings = settings_of(vm);
  settings.frame = std::move(frame);
  replace_settings(vm, std::move(settings));
}
void set_frame_position(Vm& vm, const PosC& frame) { set_frame(vm, frame.T); }
template <class Named>
void set_frame_of(Vm& vm, const Named& frame) {
  set_frame(vm, frame);
}

// Reports a fraction outside its range: E0513.
void check_share(CheckCall& call, std::string_view what) {
  const auto constant = call.constant(CallPart::first());
  if (!constant || (constant->real > 0.0 && constant->real <= 1.0)) return;
  Diagnostic d = make_diagnostic(
      "E0513", call.span(CallPart::first()),
      {std::string(what), "above 0 and at most 1", format_number(constant->real, 6)});
  d.why = "inside `with` it is a fraction of what the joints can do";
  call.report(std::move(d));
}
template <const auto& kSetting>
void check_choice(CheckCall& call) {
  const auto constant = call.constant(CallPart::first());
  if (!constant || kSetting.called(constant->text) != nullptr) return;
  Diagnostic d = make_diagnostic(
      "E0513", call.span(CallPart::first()),
      {std::string(kSetting.setting), choice_of(kSetting.names()), '"' + constant->text + '"'});
  d.fix = meant_word(constant->text, kSetting.names(), call.span(CallPart::first()));
  call.report(std::move(d));
}
void check_speed_setting(CheckCall& call) { check_share(call, "the speed"); }
void check_accel_setting(CheckCall& call) { check_share(call, "the acceleration"); }

constexpr NativeFunction kSettingsFunctions[] = {
    def<open_settings>("with()", "", "", {.in_path = true, .event = BlockEvent::kWithBegins}),
    def<close_settings>("with()", "", "", {.in_path = true, .event = BlockEvent::kWithEnds}),
    def<set_fraction<&BlockSettings::speed>>(
        "with.speed(speed: double)",
        "Moves of the joints inside the block that give neither time nor speed keep to this "
        "fraction of the speed limits of the joints. Straight moves, arcs and paths run as many "
        "times slower.",
        "with (speed: 0.5) { moveJ(home()) }", {.check = check_speed_setting}),
    def<set_fraction<&BlockSettings::accel>>(
        "with.accel(accel: double)",
        "Moves inside the block keep to this fraction of the acceleration limits of the joints.",
        "with (accel: 0.5) { moveJ(home()) }", {.check = check_accel_setting}),
    def<set_tool>(
        "with.tool(tool: posC)",
        "Moves inside the block bring this point, seen from the flange, to their targets.",
        "with (tool: xyz(z: 20mm)) { moveJ(xyz(300mm, 200mm, 200mm)) }"),
    def<set_choice<kTrack>>(
        "with.track(track: string)",
        "How moveL and moveCirc inside the block follow their way where joints would have to be "
        "fast, next to a singularity. \"exact\": the whole move is so slow that they can. "
        "\"slow\": it slows down only there. \"damped\": the joints stay slow and the hand "
        "leaves its way a little; the Move says how far, as its deviation.",
        "with (track: \"slow\") { moveL(xyz(300mm, 200mm, 200mm), speed: 200mm/s) }",
        {.check = check_choice<kTrack>}),
    def<set_choice<kTorques>>(
        "with.torques(torques: string)",
        "What becomes of a move inside the block that asks motors for more than the maxTorque of "
        "their joints. \"report\", as outside of any block: it is made, and advice says so. "
        "\"error\": it is refused before it starts. \"ignore\": it is made. \"limit\": moves "
        "without "
        "a time take as long as the motors need; those planned with Fastest use what the motors "
        "give "
        "instead of maxAccel.",
        "with (torques: \"error\") { moveJ(home()) }", {.check = check_choice<kTorques>}),
    def<set_choice<kCollisions>>(
        "with.collisions(collisions: string)",
        "What becomes of a move inside the block in which the arm, or what it carries, would run "
        "into an object, another robot or itself. \"report\", as outside of any block: it is made, "
        "and advice says which bodies meet, when, where and how deep. \"error\": it is refused "
        "before it starts. \"ignore\": it is made.",
        "with (collisions: \"error\") { moveJ(home()) }", {.check = check_choice<kCollisions>}),
    def<set_choice<kJointLimits>>(
        "with.limits(limits: string)",
        "What becomes of a move inside the block that would take joints beyond their limits. "
        "\"error\", as outside of any block: it is refused before it starts. \"clamp\": joint "
        "values "
        "that are beyond a limit become that limit, and a time that is too short the least one; "
        "places in space and lines that need more are refused. \"warn\": it is made. Advice says "
        "which joint, where and by how much, and the Move too, as its worstJoint and beyond.",
        "with (limits: \"clamp\") { moveJ(home()) }", {.check = check_choice<kJointLimits>}),
    def<set_avoid>(
        "with.avoid(avoid: bool)",
        "Whether moveJ inside the block goes around what is in its way. A move that meets nothing "
        "is the same as outside; otherwise a way is searched, made short, rounded and timed, to "
        "any "
        "solution of a target in space. Moves with a way of their own, such as moveL, are refused "
        "if they run into something.",
        "with (avoid: true) { moveJ(home()) }"),
    def<set_frame_position, set_frame_of<FrameRef>, set_frame_of<ObjectRef>>(
        "with.frame(frame: posC | frame | object)",
        "Targets in space inside the block are read in this frame. A frame or an object counts as "
        "it is when the move begins.",
        "with (frame: xyz(z: 100mm)) { moveJ(xyz(300mm, 200mm, 50mm)) }", {.in_path = true}),
};

}  // namespace

std::vector<std::string> choices_of_setting(std::string_view setting) {
  std::vector<std::string> out;
  add_choices<kTrack>(setting, out);
  add_choices<kTorques>(setting, out);
  add_choices<kCollisions>(setting, out);
  add_choices<kJointLimits>(setting, out);
  return out;
}

std::span<const NativeFunction> settings_functions() { return kSettingsFunctions; }

}  // namespace armlet::bind
