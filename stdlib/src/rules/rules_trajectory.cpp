// Rules of trajectories and of moves through several points, checked before running.

#include "messages/library_messages.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

// E0506 for two settings that exclude each other.
void refuse_both(CheckCall& call, int one, int other, std::string_view what) {
  if (!call.given(one) || !call.given(other)) return;
  Diagnostic d = make_diagnostic(row("E0506"), call.setting_span(other));
  d.message = what;
  d.related.push_back({call.setting_span(one), ""});
  d.fix = Fix{.text = "leave one of them out", .edits = without(call, other)};
  call.report(std::move(d));
}

}  // namespace

void check_arc(CheckCall& call) {
  check_time_and_speed(call, 3, 4);
  check_in_path(call, {.time = 3, .blend = 5});
}

void check_spline(CheckCall& call) {
  check_time_and_speed(call, 2, 4);
  check_planner(call, 3);
  check_joint_limits(call, 1);
}

template <bool kRobotFirst>
void check_trajectory(CheckCall& call) {
  constexpr int kName = kRobotFirst ? 1 : 0;
  constexpr int kTime = kName + 2;
  constexpr int kDurations = kName + 3;
  constexpr int kSpeed = kName + 4;
  check_planner(call, kName);
  check_time_and_speed(call, kTime, kSpeed);
  refuse_both(call, kTime, kDurations, "`time` and `durations` cannot both be given");
  refuse_both(call, kDurations, kSpeed, "`durations` and `speed` cannot both be given");
  if constexpr (kRobotFirst) check_joint_limits(call, kName + 1);
}

void check_plan(CheckCall& call) {
  check_time_and_speed(call, 2, 3);
  check_joint_limits(call, 1);
}

template void check_trajectory<true>(CheckCall& call);
template void check_trajectory<false>(CheckCall& call);

}  // namespace armlet::bind
