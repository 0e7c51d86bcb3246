// Rules of paths and of the moves in them, checked before running.

#include <fmt/format.h>

#include "armlet/core/format.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

void refuse(CheckCall& call, CallPart part, std::string_view what, std::string_view why,
            std::string_view fix) {
  if (!call.given(part)) return;
  Diagnostic d = make_diagnostic("E0502", call.setting_span(part));
  d.message = fmt::format("a move inside a `path` has no {} of its own", what);
  d.why = why;
  d.fix = Fix{.text = std::string(fix), .edits = without(call, part)};
  call.report(std::move(d));
}

}  // namespace

void check_blend(CheckCall& call, CallPart part) {
  const auto constant = call.given(part) ? call.constant(part) : std::nullopt;
  if (!constant || constant->real >= 0.0) return;
  call.report(make_diagnostic("E0513", call.span(part),
                              {"the blend", "0 mm or more", format_mm(constant->real)}));
}

void check_in_path(CheckCall& call, TakesTool takes_tool) {
  const CheckCall::InPath in_path = call.in_path();
  if (in_path == CheckCall::InPath::kYes) {
    refuse(call, at("time"), "time", "the path is one motion, planned as a whole",
           "give the whole path a time, path (time: ...)");
    if (takes_tool == TakesTool::kYes) {
      refuse(call, at("tool"), "tool", "the path is one motion of one point",
             "write with (tool: ...) around the path");
    }
  }
  if (!call.given(at("blend"))) return;
  if (in_path == CheckCall::InPath::kNo) {
    Diagnostic d = make_diagnostic(row("E0514"), call.setting_span(at("blend")));
    d.why = "a move outside a path stops exactly at its target";
    d.fix = Fix{.text = "leave it out, or put the moves that are to be joined into a path",
                .edits = without(call, at("blend"))};
    return call.report(std::move(d));
  }
  check_blend(call, at("blend"));
}

void check_joints_in_path(CheckCall& call) {
  if (call.in_path() == CheckCall::InPath::kYes) {
    for (const auto& [part, name] :
         {std::pair{at("speed"), "speed"}, {at("accel"), "acceleration"}}) {
      refuse(call, part, name,
             "it is a fraction of the joints' limits, which hold for the whole path",
             "write with (speed: ..., accel: ...) around the path");
    }
    const auto planner = call.given(at("traj")) ? call.constant(at("traj")) : std::nullopt;
    if (planner && planner->text != kPathPlanner) {
      refuse(call, at("traj"), "planner", "the speed along a path is planned as a whole",
             "leave it out");
    }
  }
  check_in_path(call, TakesTool::kNo);
}

}  // namespace armlet::bind
