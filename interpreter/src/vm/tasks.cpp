#include "vm/tasks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "vm/failures.hpp"
#include "vm/recordings.hpp"

namespace armlet::lang {

namespace {

constexpr int kMostRounds = 1000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
// Conditions can come true by time alone, so a program is stuck only if they have not for so long.
constexpr std::int64_t kPatience_ns = 3600LL * 1'000'000'000LL;

void disarm(VmState& state, Task& task) {
  state.heap.release(task.condition);
  task.condition = nullptr;
}

}  // namespace

Exit Scheduler::run(std::uint32_t function) {
  state_.running = &state_.main;
  if (!state_.enter(function, nullptr, {})) return Exit::kFailed;
  Exit exit = interpret(state_, state_.main);
  while (exit == Exit::kPaused) {
    exit = run_instant();
    if (exit == Exit::kPaused) exit = advance();
  }
  while (exit == Exit::kDone && state_.main.top > state_.main.frames)
    leave_frame(state_, state_.main);
  return exit;
}

Exit Scheduler::run_instant() {
  if (state_.recordings != nullptr)
    state_.recordings->take_due([this](Task& task) { interrupt(task); });
  for (int round = 0; round < kMostRounds; ++round) {
    evaluate_conditions();
    bool progress = false;
    for (Task* task : tasks_) {
      if (!task->waiting->is_over()) continue;
      progress = true;
      const Exit exit = resume(*task);
      if (exit != Exit::kPaused) return exit;
    }
    if (!progress) return Exit::kPaused;
  }
  fail_everywhere("R0620", {std::to_string(kMostRounds)}, {});
  return Exit::kPaused;
}

// In the order of arming, which with one task is the order of the tasks.
void Scheduler::evaluate_conditions() {
  for (Task* task : tasks_) {
    if (task->condition == nullptr) continue;
    Slot is_true{.i = 0};
    state_.running = task;
    if (!state_.evaluate(static_cast<ClosureObj*>(task->condition), is_true)) {
      interrupt(*task);
    } else if (is_true.i != 0) {
      disarm(state_, *task);
      task->waiting->stop();
    }
  }
}

Exit Scheduler::resume(Task& task) {
  const std::unique_ptr<Waiting> waiting = std::move(task.waiting);
  disarm(state_, task);
  state_.running = &task;
  resumed_ns_ = state_.vm.timeline().now_ns();
  Slot nowhere{.i = 0};
  bool failed = task.interrupted != nullptr;
  if (failed) {
    state_.fault = std::move(task.interrupted);
  } else {
    Slot& result = task.result != nullptr ? *task.result : nowhere;
    failed = waiting->finish(state_.vm, result) != Signal::kDone;
  }
  if (failed && !unwind(state_, task)) return Exit::kFailed;
  return interpret(state_, task);
}

std::int64_t Scheduler::next_instant() const {
  const Timeline& timeline = state_.vm.timeline();
  const std::int64_t now = timeline.now_ns();
  const std::int64_t tick = std::max<std::int64_t>(timeline.tick_ns(), 1);
  const std::int64_t next_tick = (now / tick + 1) * tick;
  std::int64_t next = kNever;
  bool armed = false;
  for (const Task* task : tasks_) {
    const std::int64_t due = task->waiting->due_ns();
    next = std::min(next, due > now ? due : next_tick);
    armed = armed || task->condition != nullptr;
  }
  if (armed && (next != kNever || now - resumed_ns_ < kPatience_ns))
    next = std::min(next, next_tick);
  // Nothing can happen because of a recording alone.
  if (next != kNever && state_.recordings != nullptr)
    next = std::min(next, state_.recordings->next_ns());
  return next;
}

Exit Scheduler::advance() {
  if (state_.take_cancellation()) {
    raise_cancelled(state_);
    interrupt(state_.main);
    return Exit::kPaused;
  }
  const std::int64_t next = next_instant();
  if (next == kNever) {
    fail_everywhere("R0621", {}, waited_for());
    return Exit::kPaused;
  }
  if (state_.vm.timeline().advance_to(next)) return Exit::kPaused;
  if (state_.is_leaving) return abandon();
  raise_cancelled(state_);
  interrupt(state_.main);
  return Exit::kPaused;
}

// state.fault is raised in the task once what it waits for has come to a stop.
void Scheduler::interrupt(Task& task) {
  disarm(state_, task);
  task.interrupted = std::move(state_.fault);
  task.waiting->stop();
}

// The host does not let time pass any more: nothing can be brought to a controlled stop.
Exit Scheduler::abandon() {
  Task& task = state_.main;
  state_.running = &task;
  raise_cancelled(state_);
  task.waiting.reset();
  disarm(state_, task);
  (void)unwind(state_, task);
  return Exit::kFailed;
}

void Scheduler::fail_everywhere(const char* code, const std::vector<std::string>& arguments,
                                std::string why) {
  state_.running = &state_.main;
  Diagnostic failure = start_failure(state_, code, arguments);
  failure.why = std::move(why);
  raise(state_, std::move(failure));
  interrupt(state_.main);
}

std::string Scheduler::waited_for() const {
  std::string text;
  for (const Task* task : tasks_) {
    if (!text.empty()) text += '\n';
    text += "the program waits for " + task->waiting->what();
  }
  return text;
}

}  // namespace armlet::lang
