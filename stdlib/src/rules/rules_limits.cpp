// Joint values beyond the limits of a robot, if the text shows both: E0534.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/format.hpp"
#include "armlet/model/joint.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

constexpr double kTolerance = 1e-9;  // the same as for moves, rad or m

bool is_within(double value, const std::array<double, 2>& limits) {
  return value >= limits[0] - kTolerance && value <= limits[1] + kTolerance;
}

// An equal angle, by whole revolutions, within the limits: 300 deg as -60 deg.
std::optional<double> same_angle(double value, const std::array<double, 2>& limits) {
  constexpr double kFullTurn = 2.0 * std::numbers::pi;
  const double best = std::remainder(value, kFullTurn);
  for (const double turns : {0.0, -1.0, 1.0}) {
    if (is_within(best + turns * kFullTurn, limits)) return best + turns * kFullTurn;
  }
  return std::nullopt;
}

void report_value(CheckCall& call, const RobotFact& robot, std::size_t i,
                  const PositionFact::Item& item, Span used) {
  const std::array<double, 2>& limits = *robot.limits[i];
  const double value = *item.value;
  const JointKind kind = robot.turns[i] ? JointKind::kRevolute : JointKind::kPrismatic;
  const double nearest = std::clamp(value, limits[0], limits[1]);
  const bool in_place = item.written.source == used.source && item.written.begin >= used.begin &&
                        item.written.end <= used.end && !item.written.empty();
  Diagnostic d = make_diagnostic(
      "E0534", in_place ? item.written : used,
      {std::string(call.function_name()),
       fmt::format("{} to {} for joint {} of `{}`", format_joint_value(kind, limits[0]),
                   format_joint_value(kind, limits[1]), i + 1, robot.name),
       format_joint_value(kind, value, nearest)});
  if (!in_place && !item.written.empty()) d.related.push_back({item.written, "this value"});
  d.why = fmt::format("that is {} beyond the limit of the joint",
                      format_joint_value(kind, std::abs(value - nearest)));
  const auto same = robot.turns[i] ? same_angle(value, limits) : std::nullopt;
  if (same) {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    d.fix = Fix{.text = fmt::format("the same angle within the limits is {}deg",
                                    format_number(*same * kDegrees, 4))};
  }
  call.report(std::move(d));
}

}  // namespace

void check_joint_values(CheckCall& call, const RobotFact& robot, const PositionFact& position,
                        Span used) {
  // Such values may be intended in a block `with (limits: ...)`, which may call this function.
  if (call.mentions("with.limits")) return;
  const std::size_t count = std::min(position.items.size(), robot.limits.size());
  if (position.items.size() != robot.turns.size()) return;
  for (std::size_t i = 0; i < count; ++i) {
    const PositionFact::Item& item = position.items[i];
    const bool is_known = item.value && robot.limits[i];
    const bool is_of_kind = !item.turns || *item.turns == robot.turns[i];
    if (!is_known || !is_of_kind || is_within(*item.value, *robot.limits[i])) continue;
    if (std::isfinite(*item.value)) return report_value(call, robot, i, item, used);
  }
}

void check_joint_limits(CheckCall& call, CallPart part) {
  const auto robot = robot_of(call);
  if (robot == nullptr || !call.given(part)) return;
  const auto check = [&](const std::shared_ptr<const Fact>& fact, Span used) {
    if (const auto position = std::dynamic_pointer_cast<const PositionFact>(fact))
      check_joint_values(call, *robot, *position, used);
  };
  check(call.fact(part), call.span(part));
  const Type* type = call.type(part);
  if (type == nullptr || !type->is(Kind::kList)) return;
  for (int i = 0; i < call.item_count(part); ++i)
    check(call.item_fact(part, i), call.item_span(part, i));
}

}  // namespace armlet::bind
