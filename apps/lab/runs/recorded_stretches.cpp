// What tasks do and signals are, from one wait of the run to the next.

#include <algorithm>
#include <utility>

#include "armlet/interpreter/host/inspection.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostStretches = 50'000;

}  // namespace

// Time is about to pass: until the next wait everything stays as it is now.
void Recording::take_stretches(double t) {
  if (session_ == nullptr || session_->vm() == nullptr || session_->host() == nullptr) return;
  std::vector<Going> now;
  for (TaskPlace& each : task_places(*session_->vm()))
    if (!each.at.empty())
      now.push_back({.kind = RecordedStretch::Kind::kTask,
                     .name = std::move(each.name),
                     .at = each.at,
                     .value = {},
                     .t0 = t});
  for (const auto& [name, value] : session_->host()->cell().signals().all())
    now.push_back(
        {.kind = RecordedStretch::Kind::kSignal, .name = name, .at = {}, .value = value, .t0 = t});
  if (now.empty() && going_.empty()) return;
  for (const Going& before : going_) {
    const auto same = std::ranges::find_if(
        now, [&](const Going& each) { return each.t0 == t && each.is_same(before); });
    if (same != now.end() && before.t0 < t)
      same->t0 = before.t0;
    else if (same == now.end())
      end_stretch(before, t);
  }
  going_ = std::move(now);
}

void Recording::end_stretch(const Going& going, double t) {
  if (!(t > going.t0) || record_.stretches.size() >= kMostStretches) return;
  record_.stretches.push_back(
      {.kind = going.kind,
       .name = going.name,
       .t0 = going.t0,
       .t1 = t,
       .span = going.at.empty() ? std::nullopt : span_of(session_->sources(), going.at),
       .value = going.value});
}

}  // namespace armlet::lab
