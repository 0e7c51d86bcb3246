#include "rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "armlet/core/format.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/interpreter/world_names.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/planner.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules_settings.hpp"

namespace armlet::bind {
namespace {

constexpr std::array<std::string_view, 12> kOrdinals = {"first", "second", "third",    "fourth",
                                                        "fifth", "sixth",  "seventh",  "eighth",
                                                        "ninth", "tenth",  "eleventh", "twelfth"};
std::string_view ordinal(int index) {
  return kOrdinals[static_cast<std::size_t>(std::min(index, 11))];
}

std::string joint_list(const RobotFact& robot) {
  std::string text = fmt::format("`{}` has joints: ", robot.name);
  for (std::size_t i = 0; i < robot.turns.size(); ++i)
    text += fmt::format("{}{}", i > 0 ? ", " : "", robot.turns[i] ? "turn" : "slide");
  return text;
}

std::string count_of(int count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

void set_position_fact(CheckCall& call, int count, std::vector<PositionFact::Item> items) {
  auto fact = std::make_shared<PositionFact>();
  fact->count = count;
  fact->items = std::move(items);
  call.set_result_fact(std::move(fact));
}

// The values of posJ(30deg, x, 50mm), as far as they are known from the text.
std::vector<PositionFact::Item> written_values(const CheckCall& call, int count) {
  std::vector<PositionFact::Item> out;
  for (int i = 0; i < count; ++i) {
    const auto constant = call.item_constant(CallPart::first(), i);
    const Type* type = call.item_type(CallPart::first(), i);
    PositionFact::Item& item = out.emplace_back();
    item.written = call.item_span(CallPart::first(), i);
    if (constant) item.value = constant->real;
    if (type != nullptr && type->is_quantity()) item.turns = type->dim == dims::kAngle;
  }
  return out;
}

// E0302 for a posJ with `count` values; item_span gives the span of one item.
template <class ItemSpan>
void report_count(CheckCall& call, const RobotFact& robot, int count, Span whole,
                  ItemSpan item_span) {
  const int joints = static_cast<int>(robot.turns.size());
  const bool too_many = count > joints;
  const Span span = too_many ? item_span(joints) : whole;
  Diagnostic d = make_diagnostic(row("E0302"), span.empty() ? whole : span,
                                 {count_of(count, "joint value"), count_of(joints, "joint")});
  const int missing = joints - count;
  if (too_many) {
    d.mark.label =
        count == joints + 1 ? "one too many" : fmt::format("{} too many", count - joints);
    d.fix = Fix{.text = count == joints + 1
                            ? fmt::format("remove the {} value", ordinal(joints))
                            : fmt::format("remove the values after the {}", ordinal(joints - 1))};
    const Span last_good = joints > 0 ? item_span(joints - 1) : Span{};
    const Span last = item_span(count - 1);
    if (!last_good.empty() && !last.empty())
      d.fix->edits.push_back({{last_good.end, last.end, last.source}, ""});
  } else {
    d.mark.label = missing == 1 ? "one too few" : fmt::format("{} too few", missing);
    d.fix = Fix{.text = fmt::format(
                    "add the {} value, {}", ordinal(count),
                    robot.turns[count] ? "an angle such as 30deg" : "a length such as 30mm")};
  }
  d.why = joint_list(robot);
  call.report(std::move(d));
}

// 90 -> "90deg (or 90rad, which is more than 14 turns)"
std::string unit_fix(double value, std::string_view text, bool turns) {
  if (!turns)
    return std::abs(value) >= 1.0 ? fmt::format("write {}mm", text)
                                  : fmt::format("write {}m", text);
  const int whole = static_cast<int>(std::abs(value) / (2.0 * std::numbers::pi));
  if (whole >= 1)
    return fmt::format("write {}deg (or {}rad, which is more than {} turn{})", text, text, whole,
                       whole == 1 ? "" : "s");
  return fmt::format("write {}rad or {}", text,
                     format_number(value * 180.0 / std::numbers::pi, 4) + "deg");
}

void report_missing_unit(CheckCall& call, const RobotFact* robot, int item, double value) {
  const Span span = call.item_span(CallPart::first(), item);
  Diagnostic d = make_diagnostic("E0401", span);
  d.mark.label = "plain number";
  const bool turns = robot == nullptr || robot->turns[item];
  if (robot != nullptr) {
    d.why = fmt::format("joint {} of `{}` {}, so its value is {}", item + 1, robot->name,
                        turns ? "turns" : "slides", turns ? "an angle" : "a length");
  } else {
    d.why = "a joint value is an angle or a length, depending on the joint";
  }
  const std::string text = call.text_of(span);
  const char* unit = turns ? (std::abs(value) > 2.0 * std::numbers::pi ? "deg" : "rad")
                           : (std::abs(value) >= 1.0 ? "mm" : "m");
  if (text.find_first_not_of("0123456789.-") == std::string::npos) {
    d.fix = Fix{.text = unit_fix(value, text, turns),
                .edits = {{Span{span.end, span.end, span.source}, unit}}};
  } else {  // 45 / 2
    const std::string product = fmt::format("({}) * 1{}", text, unit);
    d.fix = Fix{.text = "write " + product, .edits = {{span, product}}};
  }
  call.report(std::move(d));
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

void report_wrong_kind(CheckCall& call, const RobotFact& robot, int item, const Type* type) {
  Diagnostic d = make_diagnostic(
      row("E0404"), call.item_span(CallPart::first(), item),
      {std::to_string(item + 1), robot.turns[item] ? "turns" : "slides",
       robot.turns[item] ? "an angle" : "a length", std::string(type_phrase(type))});
  d.mark.label = fmt::format("{} value", ordinal(item));
  d.why = joint_list(robot);
  // 30deg for a prismatic joint: the number is kept.
  const std::string text = call.text_of(call.item_span(CallPart::first(), item));
  const std::size_t digits = text.find_first_not_of("0123456789._-");
  const bool is_literal = digits != std::string::npos && digits > 0 &&
                          std::ranges::all_of(text.substr(digits), is_letter);
  const std::string unit = robot.turns[item] ? "deg" : "mm";
  const std::string other = (is_literal ? text.substr(0, digits) : "30") + unit;
  d.fix = Fix{.text = (robot.turns[item] ? "write an angle such as " : "write a length such as ") +
                      other};
  if (is_literal) d.fix->edits = {{call.item_span(CallPart::first(), item), other}};
  call.report(std::move(d));
}

}  // namespace

void check_posj_values(CheckCall& call) {
  const int count = call.item_count(CallPart::first());
  const auto robot = ambient_robot(call);
  const bool fits = robot != nullptr && static_cast<int>(robot->turns.size()) == count;
  if (robot == nullptr || fits) set_position_fact(call, count, written_values(call, count));
  for (int i = 0; i < count; ++i) {
    const Type* type = call.item_type(CallPart::first(), i);
    if (type == nullptr || type->is(Kind::kAny)) continue;
    const auto constant = call.item_constant(CallPart::first(), i);
    const bool plain = !type->is_quantity();
    if (plain) {
      const bool zero = constant && constant->real == 0.0;
      if (!zero)
        return report_missing_unit(call, fits ? robot.get() : nullptr, i,
                                   constant ? constant->real : 1.0);
      continue;
    }
    if (fits && type->dim != (robot->turns[i] ? dims::kAngle : dims::kLength))
      return report_wrong_kind(call, *robot, i, type);
    if (type->dim != dims::kAngle && type->dim != dims::kLength) {
      Diagnostic d = make_diagnostic(row("E0404"), call.item_span(CallPart::first(), i),
                                     {std::to_string(i + 1), "turns or slides",
                                      "an angle or a length", std::string(type_phrase(type))});
      d.mark.label = fmt::format("{} value", ordinal(i));
      return call.report(std::move(d));
    }
  }
  if (robot != nullptr && !fits) {
    report_count(call, *robot, count, call.call_span(),
                 [&](int i) { return call.item_span(CallPart::first(), i); });
  }
}

void check_posj_list(CheckCall& call) {
  const auto constant = call.constant(CallPart::first());
  const auto robot = ambient_robot(call);
  if (!constant || constant->kind != Constant::Kind::kList) return;
  const int count = static_cast<int>(constant->items.size());
  if (robot != nullptr && static_cast<int>(robot->turns.size()) != count) {
    return report_count(call, *robot, count, call.span(CallPart::first()),
                        [&](int i) { return call.origin(CallPart::first(), i); });
  }
  // A list in a variable may change before it is used; the run reports where it was set (R0602).
  std::vector<PositionFact::Item> items;
  const Span used = call.span(CallPart::first());
  for (int i = 0; i < count; ++i) {
    const Span origin = call.origin(CallPart::first(), i);
    const bool in_place =
        origin.source == used.source && origin.begin >= used.begin && origin.end <= used.end;
    items.push_back({.written = origin});
    if (in_place) items.back().value = constant->items[static_cast<std::size_t>(i)].real;
  }
  set_position_fact(call, count, std::move(items));
  const Type* type = call.type(CallPart::first());
  const bool plain = type != nullptr && type->is(Kind::kList) && !type->element->is_quantity();
  if (plain) advise_degrees(call, CallPart::first(), constant->items, robot.get());
}

// ---- moves --------------------------------------------------------------------------------------

// "Syn, Asyn and Trap"
static std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

void check_planner(CheckCall& call, CallPart part) {
  const auto constant = call.constant(part);
  if (!constant || constant->kind != Constant::Kind::kText) return;
  const auto* host = static_cast<const Host*>(call.host());
  const PlannerSet planners = host != nullptr ? host->planners() : PlannerSet();
  const std::string& name = constant->text;
  if (planners.has(name) || call.mentions("addPlanner")) return;
  const std::vector<std::string> names = planners.names();
  const std::vector<std::string_view> all(names.begin(), names.end());
  const Span span = call.span(part);
  Diagnostic d = make_diagnostic(row("E0202"), span, {name});
  d.why = "the planners are " + listed(names);
  if (const auto meant = most_similar(name, all)) {
    d.fix = Fix{.text = fmt::format("did you mean \"{}\"?", *meant),
                .edits = {{span, fmt::format("\"{}\"", *meant)}},
                .confidence = Confidence::kSure};
  }
  call.report(std::move(d));
}

void check_joint_target(CheckCall& call, CallPart part) {
  const auto robot = robot_of(call);
  const auto position = std::dynamic_pointer_cast<const PositionFact>(call.fact(part));
  if (robot == nullptr || position == nullptr) return;
  if (position->count != static_cast<int>(robot->turns.size())) {
    report_count(call, *robot, position->count, call.span(part), [&](int) { return Span{}; });
  } else {
    check_joint_limits(call, part);
  }
}

std::vector<Edit> without(const CheckCall& call, CallPart part) {
  Span setting = call.setting_span(part);
  const std::uint32_t begin = call.call_span().begin;
  const std::string before = call.text_of({begin, setting.begin, setting.source});
  const std::size_t comma = before.find_last_not_of(" \t\r\n");
  if (comma == std::string::npos || before[comma] != ',') return {};
  setting.begin = begin + static_cast<std::uint32_t>(comma);
  return {{setting, ""}};
}

void check_duration(CheckCall& call, CallPart part) {
  const auto constant = call.given(part) ? call.constant(part) : std::nullopt;
  if (!constant || !(constant->real < 0.0)) return;
  call.report(make_diagnostic("E0513", call.span(part),
                              {"the time", "0 or more", format_number(constant->real, 6) + " s"}));
}

void check_time_and_speed(CheckCall& call) {
  constexpr CallPart time = at("time"), speed = at("speed");
  if (call.given(time) && call.given(speed)) {
    Diagnostic d = make_diagnostic(row("E0506"), call.setting_span(speed));
    d.related.push_back({call.setting_span(time), ""});
    d.fix = Fix{.text = "leave one of them out", .edits = without(call, speed)};
    return call.report(std::move(d));
  }
  check_duration(call, time);
}

void check_move_joints(CheckCall& call) {
  check_joint_target(call, at("target"));
  check_move_position(call);
  if (!call.given(at("near"))) return;
  Diagnostic d = make_diagnostic("E0207", call.setting_span(at("near")), {"moveJ", "near"});
  d.why = "near chooses among the joint values that reach a place; a posJ is such values already";
  d.fix = Fix{.text = "leave near out",
              .edits = without(call, at("near")),
              .confidence = Confidence::kSure};
  call.report(std::move(d));
}
void check_move_position(CheckCall& call) {
  check_time_and_speed(call);
  check_fraction(call, at("speed"));
  check_fraction(call, at("accel"));
  check_planner(call, at("traj"));
  check_joints_in_path(call);
}
void check_move_line(CheckCall& call) {
  check_time_and_speed(call);
  check_positive(call, at("speed"));
  check_positive(call, at("accel"));
  check_in_path(call, TakesTool::kYes);
}

void check_classic_joints(CheckCall& call) {
  check_planner(call, at("traj"));
  check_joint_target(call, at("p"));
  check_duration(call, at("time"));
}
void check_classic_position(CheckCall& call) {
  check_planner(call, at("traj"));
  check_duration(call, at("time"));
}

void explain_list_for_posj(CheckCall& call) {
  const Span span = call.span(at("q"));
  Diagnostic d = make_diagnostic("E0301", span, {"second", "a position"});
  d.mark.label = fmt::format("this is {}", type_phrase(call.type(at("q"))));
  const std::string_view wanted = call.function_name() == "moveC" ? "posC" : "posJ";
  d.why = fmt::format("`{}` moves to a {}, an object made from the numbers", call.function_name(),
                      wanted);
  const std::string whole = call.text_of(call.call_span());
  const std::string value = call.text_of(span);
  const std::size_t offset = span.begin - call.call_span().begin;
  const std::string made = fmt::format("new {}({})", wanted, value);
  d.fix = Fix{.text = fmt::format("write {}{}{};", whole.substr(0, offset), made,
                                  whole.substr(offset + value.size())),
              .edits = {{span, made}},
              .confidence = Confidence::kSure};
  call.report(std::move(d));
}

void explain_arc(CheckCall& call) {
  Diagnostic d = make_diagnostic(row("E0503"), call.callee_span());
  d.why = "other robot languages use MoveC for circles; here C stands for Cartesian";
  const std::string whole = call.text_of(call.call_span());
  const std::size_t name_end = call.callee_span().end - call.call_span().begin;
  d.fix = Fix{.text = fmt::format("write moveCirc{}", whole.substr(name_end)),
              .edits = {{call.callee_span(), "moveCirc"}},
              .confidence = Confidence::kSure};
  call.report(std::move(d));
}

// ---- objects ------------------------------------------------------------------------------------

namespace {

// A length of a shape: its parameter, and what messages call it.
struct Length {
  CallPart part;
  std::string_view name;
};

void check_lengths(CheckCall& call, std::initializer_list<Length> lengths) {
  for (const auto& [part, name] : lengths) {
    const auto constant = call.constant(part);
    if (!constant || constant->real > 0.0) continue;
    return call.report(make_diagnostic(
        "E0513", call.span(part),
        {fmt::format("the {}", name), "more than 0 mm", format_mm(constant->real)}));
  }
}

}  // namespace

void check_box(CheckCall& call) {
  check_lengths(call, {{at("x"), "length x"}, {at("y"), "length y"}, {at("z"), "length z"}});
}
void check_cylinder(CheckCall& call) {
  check_lengths(call, {{at("radius"), "radius"}, {at("height"), "height"}});
}
void check_plane(CheckCall& call) {
  check_lengths(call, {{at("x"), "length x"}, {at("y"), "length y"}});
}
void check_sphere(CheckCall& call) { check_lengths(call, {{at("radius"), "radius"}}); }

void check_object_name(CheckCall& call) {
  const auto constant = call.constant(CallPart::first());
  const WorldNames* world = call.world();
  if (!constant || world == nullptr) return;
  const std::string& name = constant->text;
  if (call.declares("object", name)) return;
  call.use_world();
  if (call.mentions("spawn") || world->has(name)) return;
  Diagnostic d = make_diagnostic(row("E0203"), call.span(CallPart::first()), {name});
  if (!call.takes_errors()) return call.report(std::move(d));
  std::vector<std::string> known;
  for (const std::string& thing : world->things) {
    if (!call.declares("object", thing)) known.push_back(thing);
  }
  const std::vector<std::string> declared = call.declared_names("object");
  known.insert(known.end(), declared.begin(), declared.end());
  std::string list;
  for (std::size_t i = 0; i < known.size(); ++i) {
    list += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == known.size() ? " and " : ", ", known[i]);
  }
  d.why = known.empty() ? fmt::format("the world `{}` is empty", world->world)
                        : fmt::format("the world `{}` contains {}", world->world, list);
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  if (const auto meant = most_similar(name, candidates)) {
    d.fix = Fix{.text = fmt::format("did you mean \"{}\"?", *meant),
                .edits = {{call.span(CallPart::first()), fmt::format("\"{}\"", *meant)}},
                .confidence = Confidence::kSure};
  }
  call.report(std::move(d));
}

}  // namespace armlet::bind
