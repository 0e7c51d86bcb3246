// Statements of tasks and values of signals, from one wait of the run to the next.

#include <algorithm>
#include <numeric>
#include <utility>

#include "armlet/interpreter/host/inspection.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostStretches = 50'000;

}  // namespace

// Called before the clock advances: everything stays the same until the next wait.
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
  // Both lists have the same order, so that one pass finds equal intervals; each is matched once.
  std::vector<std::size_t> order = order_of(now);
  std::vector<bool> goes_on(going_.size());
  auto next = order.begin();
  for (const std::size_t i : going_order_) {
    const Going& before = going_[i];
    while (next != order.end() && now[*next].place() < before.place()) ++next;
    if (next == order.end()) break;
    if (!now[*next].is_same(before)) continue;
    goes_on[i] = true;
    if (before.t0 < t) now[*next++].t0 = before.t0;
  }
  for (std::size_t i = 0; i < going_.size(); ++i)
    if (!goes_on[i]) end_stretch(going_[i], t);
  going_ = std::move(now);
  going_order_ = std::move(order);
}

std::vector<std::size_t> Recording::order_of(const std::vector<Going>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all[i].place(); });
  return order;
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
