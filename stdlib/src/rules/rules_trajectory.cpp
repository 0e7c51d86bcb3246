// Rules of trajectories and of moves through several points, checked before running.

#include "messages/library_messages.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

// E0506 for two settings that exclude each other.
void refuse_both(CheckCall& call, CallPart one, CallPart other, std::string_view what) {
  if (!call.given(one) || !call.given(other)) return;
  Diagnostic d = make_diagnostic(row("E0506"), call.setting_span(other));
  d.message = what;
  d.related.push_back({call.setting_span(one), ""});
  d.fix = Fix{.text = "leave one of them out", .edits = without(call, other)};
  call.report(std::move(d));
}

}  // namespace

void check_arc(CheckCall& call) {
  check_time_and_speed(call);
  check_in_path(call, TakesTool::kNo);
}

void check_spline(CheckCall& call) {
  check_time_and_speed(call);
  check_planner(call, at("traj"));
  check_joint_limits(call, at("points"));
}

template <bool kRobotFirst>
void check_trajectory(CheckCall& call) {
  check_planner(call, at("name"));
  check_time_and_speed(call);
  refuse_both(call, at("time"), at("durations"), "`time` and `durations` cannot both be given");
  refuse_both(call, at("durations"), at("speed"), "`durations` and `speed` cannot both be given");
  if constexpr (kRobotFirst) check_joint_limits(call, at("points"));
}

void check_plan(CheckCall& call) {
  check_time_and_speed(call);
  check_joint_limits(call, at("to"));
}

template void check_trajectory<true>(CheckCall& call);
template void check_trajectory<false>(CheckCall& call);

}  // namespace armlet::bind
