// Rules of paths and of the moves in them, checked before running.

#include <fmt/format.h>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

void refuse(CheckCall& call, int parameter, std::string_view what, std::string_view why,
            std::string_view fix) {
  if (!call.given(parameter)) return;
  Diagnostic d = make_diagnostic("E0502", call.setting_span(parameter));
  d.message = fmt::format("a move inside a `path` has no {} of its own", what);
  d.why = why;
  d.fix = Fix{.text = std::string(fix), .edits = without(call, parameter)};
  call.report(std::move(d));
}

}  // namespace

void check_blend(CheckCall& call, int parameter) {
  const auto constant = call.given(parameter) ? call.constant(parameter) : std::nullopt;
  if (!constant || constant->real >= 0.0) return;
  call.report(make_diagnostic("E0513", call.span(parameter),
                              {"the blend", "0 mm or more", format_mm(constant->real)}));
}

void check_in_path(CheckCall& call, const PathParameters& parameters) {
  const CheckCall::InPath in_path = call.in_path();
  if (in_path == CheckCall::InPath::kYes) {
    refuse(call, parameters.time, "time", "the path is one motion, planned as a whole",
           "give the whole path a time, path (time: ...)");
    if (parameters.tool >= 0) {
      refuse(call, parameters.tool, "tool", "the path is one motion of one point",
             "write with (tool: ...) around the path");
    }
  }
  if (!call.given(parameters.blend)) return;
  if (in_path == CheckCall::InPath::kNo) {
    Diagnostic d = make_diagnostic(row("E0514"), call.setting_span(parameters.blend));
    d.why = "a move outside a path stops exactly at its target";
    d.fix = Fix{.text = "leave it out, or put the moves that are to be joined into a path",
                .edits = without(call, parameters.blend)};
    return call.report(std::move(d));
  }
  check_blend(call, parameters.blend);
}

void check_joints_in_path(CheckCall& call, int blend) {
  if (call.in_path() == CheckCall::InPath::kYes) {
    for (const auto& [parameter, name] : {std::pair{3, "speed"}, {4, "acceleration"}}) {
      refuse(call, parameter, name,
             "it is a fraction of the joints' limits, which hold for the whole path",
             "write with (speed: ..., accel: ...) around the path");
    }
    const auto planner = call.given(5) ? call.constant(5) : std::nullopt;
    if (planner && planner->text != kPathPlanner) {
      refuse(call, 5, "planner", "the speed along a path is planned as a whole", "leave it out");
    }
  }
  check_in_path(call, {.time = 2, .blend = blend});
}

}  // namespace armlet::bind
