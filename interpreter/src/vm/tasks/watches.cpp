// The conditions that are checked while time passes: those of waiting tasks, and the watches of
// blocks.

#include <string>

#include "vm/failures/failures.hpp"
#include "vm/state/task_tree.hpp"

namespace armlet::lang {

void TaskTree::arm(Task& task) {
  task.armed = ++last_order_;
  armed_[task.armed] = {&task, nullptr};
}

void TaskTree::disarm(Task& task) {
  if (task.armed != 0) armed_.erase(task.armed);
  task.armed = 0;
  task.waits_until = task.came_true = false;
  state_.heap.release(task.condition);
  task.condition = nullptr;
}

void TaskTree::disarm(Watch& watch) {
  if (watch.order != 0) armed_.erase(watch.order);
  watch.order = 0;
}

Watch& TaskTree::watch(Task& owner, Obj* condition, Obj* body) {
  owner.children.regions.back().push_back(std::make_unique<Watch>());
  Watch& watch = *owner.children.regions.back().back();
  watch.owner = &owner;
  watch.region = owner.children.regions.size() - 1;
  watch.condition = condition;
  watch.body = body;
  watch.host_data = owner.host_data;
  retain_object(condition);
  retain_object(body);
  watch.order = ++last_order_;
  armed_[watch.order] = {nullptr, &watch};
  return watch;
}

bool TaskTree::start(Watch& watch) {
  state_.running = watch.owner;  // a failure belongs to this task
  Task* body = create(*watch.owner, watch.body);
  if (body == nullptr) return false;
  body->origin.watch = &watch;
  body->host_data = watch.host_data;
  watch.running = body;
  return true;
}

// The error ends the statements of the block, up to the block itself. A block at its end waits for
// its tasks, so the error is raised there directly.
void TaskTree::fail_block(Watch& watch, const FaultPtr& fault) {
  Task& owner = *watch.owner;
  watch.has_failed = true;
  const bool is_ending =
      owner.children.ending != kNoRegion && watch.region >= owner.children.ending;
  auto raised = std::make_shared<Fault>(*fault);
  if (!raised->is_leaving) {
    raised->reach = is_ending ? Reach::kHandlers : Reach::kFinally;
    raised->region = is_ending ? kNoRegion : watch.region;
  }
  if (is_ending) cancel_bodies(owner, owner.children.ending, Reach::kFinally);
  interrupt(owner, std::move(raised));
}

bool TaskTree::start_beats() {
  const std::int64_t now = state_.vm.timeline().now_ns();
  bool any = false;
  for (auto next = armed_.begin(); next != armed_.end();) {
    const auto [order, armed] = *next;
    Watch* watch = armed.watch;
    const bool beats = watch != nullptr && watch->condition == nullptr;
    if (beats && watch->running == nullptr && watch->next_ns <= now) {
      any = true;
      watch->next_ns += watch->period_ns;
      if (!start(*watch)) fail_block(*watch, std::move(state_.fault));
    }
    next = armed_.upper_bound(order);
  }
  return any;
}

// No beat starts while the body runs; those that pass meanwhile are counted afterwards.
void TaskTree::skip_beats(Watch& watch) {
  const std::int64_t late = state_.vm.timeline().now_ns() - watch.next_ns;
  const bool beats = watch.condition == nullptr && watch.order != 0 && watch.running != nullptr;
  if (!beats || late <= 0) return;
  const std::int64_t passed = (late - 1) / watch.period_ns + 1;
  Skips& skips = skips_[{watch.head.source, watch.head.begin}];
  skips.head = watch.head;
  skips.count += passed;
  watch.next_ns += passed * watch.period_ns;
}

void TaskTree::stop_watching(Task& owner, std::size_t from) {
  for (std::size_t i = from; i < owner.children.regions.size(); ++i) {
    for (const auto& watch : owner.children.regions[i]) {
      skip_beats(*watch);
      disarm(*watch);
    }
  }
}

void TaskTree::cancel_bodies(Task& owner, std::size_t from, Reach reach) {
  for (std::size_t i = from; i < owner.children.regions.size(); ++i) {
    for (const auto& watch : owner.children.regions[i]) {
      if (watch->running != nullptr) cancel(*watch->running, reach);
    }
  }
}

bool TaskTree::has_bodies(const Task& owner, std::size_t from) {
  for (std::size_t i = from; i < owner.children.regions.size(); ++i) {
    for (const auto& watch : owner.children.regions[i]) {
      if (watch->running != nullptr) return true;
    }
  }
  return false;
}

void TaskTree::close_regions(Task& owner, std::size_t from) {
  while (owner.children.regions.size() > from) {
    for (const auto& watch : owner.children.regions.back()) {
      state_.heap.release(watch->condition);
      state_.heap.release(watch->body);
    }
    owner.children.regions.pop_back();
  }
}

void TaskTree::wake_watches() {
  std::vector<Region>& regions = state_.main.children.regions;
  if (regions.empty()) regions.emplace_back();
  for (const auto& watch : regions[0]) {
    if (watch->has_failed) continue;
    watch->order = ++last_order_;
    armed_[watch->order] = {nullptr, watch.get()};
  }
}

void TaskTree::forget_watches(std::size_t first) {
  std::vector<Region>& regions = state_.main.children.regions;
  while (!regions.empty() && regions[0].size() > first) {
    Watch& watch = *regions[0].back();
    disarm(watch);
    state_.heap.release(watch.condition);
    state_.heap.release(watch.body);
    regions[0].pop_back();
  }
}

void TaskTree::report_skipped() {
  for (const auto& [place, skips] : skips_) {
    if (!state_.options.advice) return;
    const std::string beats = skips.count == 1 ? " beat" : " beats";
    state_.options.advice(
        make_diagnostic("W0706", skips.head, {std::to_string(skips.count) + beats}));
  }
  skips_.clear();
}

}  // namespace armlet::lang
