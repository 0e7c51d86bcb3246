// Joint values as plain numbers: radians that look like degrees (W0702).

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "messages/library_messages.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

constexpr double kRevolution = 2.0 * std::numbers::pi;
constexpr double kMoreThanARevolution = kRevolution * 1.001;  // 6.2832 is still one revolution
constexpr double kNoAngle = 1e6;  // from here on, infinity included, it is no angle in degrees

// In braces one unit is enough; a list in brackets has values of one type: its numbers stay plain
// and are multiplied.
constexpr std::string_view kUnit = "deg";
constexpr std::string_view kFactor = " * PI / 180";

// The list as written, with degrees where degrees are probably meant.
struct Rewritten {
  int first = -1;  // the first value that looks like degrees
  bool braces = false;
  std::string text;
  std::vector<Edit> edits;
};

Rewritten with_degrees(const CheckCall& call, CallPart part, const std::vector<Constant>& items,
                       const RobotFact* robot) {
  Rewritten out;
  const Span begin = call.origin(part, 0);
  out.braces = begin.begin > 0 && call.text_of({begin.begin - 1, begin.begin, begin.source}) == "{";
  const std::string_view suffix = out.braces ? kUnit : kFactor;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool turns = robot == nullptr || i >= robot->turns.size() || robot->turns[i];
    const double size = std::abs(items[i].real);
    const bool many = turns && size > kMoreThanARevolution && size < kNoAngle;
    const Span origin = call.origin(part, static_cast<int>(i));
    if (origin.empty()) return {};
    if (many && out.first < 0) out.first = static_cast<int>(i);
    out.text += fmt::format("{}{}{}", i > 0 ? ", " : "", call.text_of(origin), many ? suffix : "");
    if (many) out.edits.push_back({{origin.end, origin.end, origin.source}, std::string(suffix)});
  }
  return out;
}

bool is_inside(Span inner, Span outer) {
  return inner.source == outer.source && inner.begin >= outer.begin && inner.end <= outer.end;
}

std::string revolutions_text(double value) {
  const int turns = static_cast<int>(std::abs(value) / kRevolution);
  return turns == 1 ? "a turn" : fmt::format("{} turns", turns);
}

}  // namespace

void advise_degrees(CheckCall& call, CallPart part, const std::vector<Constant>& items,
                    const RobotFact* robot) {
  Rewritten meant = with_degrees(call, part, items, robot);
  if (meant.first < 0) return;
  const Span origin = call.origin(part, meant.first);
  const Span used = call.span(part);
  // A list written in the call itself is marked at the number.
  const bool in_place = is_inside(origin, used);
  Diagnostic d =
      make_diagnostic(row("W0702"), in_place ? origin : used,
                      {fmt::format("{} rad", call.text_of(origin)),
                       revolutions_text(items[static_cast<std::size_t>(meant.first)].real)});
  d.mark.label = "plain numbers count as radians and metres";
  if (!in_place) d.related.push_back({origin, ""});
  d.fix = Fix{.text = meant.braces ? fmt::format("write {{{}}}", meant.text)
                                   : fmt::format("write [{}]", meant.text),
              .edits = std::move(meant.edits)};
  call.report(std::move(d));
}

void check_list_of_joints(CheckCall& call, CallPart part) {
  if (!call.given(part)) return;
  const auto constant = call.constant(part);
  if (!constant || constant->kind != Constant::Kind::kList) return;
  const Type* type = call.type(part);
  if (type == nullptr || !type->is(Kind::kList) || type->element->is_quantity()) return;
  advise_degrees(call, part, constant->items, robot_of(call).get());
}

std::shared_ptr<const RobotFact> ambient_robot(const CheckCall& call) {
  return std::dynamic_pointer_cast<const RobotFact>(call.ambient_fact("robot"));
}

std::shared_ptr<const RobotFact> robot_of(const CheckCall& call) {
  if (call.given(CallPart::first()))
    return std::dynamic_pointer_cast<const RobotFact>(call.fact(CallPart::first()));
  return ambient_robot(call);
}

}  // namespace armlet::bind
