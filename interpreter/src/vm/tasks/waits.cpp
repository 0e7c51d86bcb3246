// Waits for a time and for a condition.

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/interpreter/resource.hpp"
#include "armlet/interpreter/virtual_time.hpp"
#include "vm/failures/failures.hpp"
#include "vm/failures/leaving.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/tasks/busy_wait.hpp"
#include "vm/values/durations.hpp"

namespace armlet::lang {

namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
class Sleep final : public Waiting {
 public:
  Sleep(Timeline& timeline, std::int64_t due_ns) : timeline_(timeline), due_ns_(due_ns) {}

  [[nodiscard]] std::int64_t due_ns() const override { return due_ns_; }
  [[nodiscard]] bool is_over() const override { return timeline_.now_ns() >= due_ns_; }
  void stop() override { due_ns_ = std::min(due_ns_, timeline_.now_ns()); }
  Signal finish(Vm&, Slot&) override { return Signal::kDone; }
  [[nodiscard]] std::string what() const override { return "a time"; }

 private:
  Timeline& timeline_;
  std::int64_t due_ns_;
};

// The states of the other tasks, one line each, as possible reasons why a condition did not become
// true.
std::string others(const VmState& state) {
  constexpr int kMost = 3;
  std::string text;
  int lines = 0;
  const auto add = [&](const Task& task) {
    const bool waits = task.waiting != nullptr && !task.waits_for_its_tasks();
    if (&task == state.running || task.has_ended || !waits || ++lines > kMost) return;
    const Resource resource = task.waiting->resource();
    const ResourceWords* words = resource.type == nullptr ? nullptr : resource.type->resource;
    const std::string name = task_name(task);
    const std::string line = " is at line " + std::to_string(task_line(state, task));
    if (!text.empty()) text += '\n';
    if (words != nullptr) {
      text += words->called(resource.name) + line + ", " + std::string(words->still);
    } else {
      text +=
          (name.empty() ? "the program" : name) + line + ", waiting for " + task.waiting->what();
    }
  };
  add(state.main);
  for (const auto& task : state.tree.all()) add(*task);
  return text;
}

// `wait until`: ends when the task's armed condition becomes true, or after the timeout.
class WaitUntil final : public Waiting {
 public:
  // timeout_ns  a negative number: none.
  WaitUntil(VmState& state, const hir::WaitUntilStmt& statement, double timeout,
            std::int64_t timeout_ns)
      : state_(state),
        statement_(statement),
        timeout_(timeout),
        armed_ns_(state.vm.timeline().now_ns()) {
    if (timeout_ns >= 0) due_ns_ = armed_ns_ + timeout_ns;
  }

  [[nodiscard]] std::int64_t due_ns() const override { return due_ns_; }
  [[nodiscard]] bool is_over() const override {
    return stopped_ || state_.vm.timeline().now_ns() >= due_ns_;
  }
  void stop() override { stopped_ = true; }
  [[nodiscard]] std::string what() const override {
    return "`" + std::string(statement_.condition_text) + "`";
  }

  Signal finish(Vm&, Slot&) override {
    if (stopped_) return Signal::kDone;
    Diagnostic failure = make_diagnostic(
        "R0607", statement_.condition_span,
        {quantity_text(timeout_, dims::kTime), std::string(statement_.condition_text)});
    char since[64];
    std::snprintf(since, sizeof since, "false since t = %.2f s", seconds_of(armed_ns_));
    failure.mark.label = since;
    failure.why = others(state_);
    failure.fix = Fix{"use a longer timeout, or catch the error", {}, Confidence::kMaybe};
    raise(state_, std::move(failure));
    return Signal::kFail;
  }

 private:
  VmState& state_;
  const hir::WaitUntilStmt& statement_;
  double timeout_;
  std::int64_t armed_ns_;
  std::int64_t due_ns_ = kNever;
  bool stopped_ = false;
};

}  // namespace

bool raise_may_not_pause(VmState& state) {
  const CodeSpan* at = code_span(state);
  const std::string text =
      at == nullptr ? "" : std::string(state.programs.newest->sources->slice(at->span));
  const bool is_short = !text.empty() && text.size() <= 40;
  return raise(state, "R0632",
               {is_short ? "`" + text + "`" : "this", state.programs.newest->what_takes_time});
}

bool op_wait(VmState& state, Slot* base, const Instr* pc) {
  const double seconds = base[pc->a].d;
  if (state.host.calls > 0) return raise_may_not_pause(state);
  std::int64_t ns = 0;
  if (!check_time(state, {.what = "a wait", .time = "the time to wait"}, seconds, ns)) return false;
  Timeline& timeline = state.vm.timeline();
  state.pending = std::make_unique<Sleep>(timeline, timeline.now_ns() + ns);
  return true;
}

bool op_waituntil(VmState& state, Slot* base, const Instr* pc) {
  if (state.host.calls > 0) return raise_may_not_pause(state);
  const Slot timeout = base[pc->b];
  std::int64_t ns = -1;
  const bool limited = !is_absent_scalar(timeout);
  if (limited &&
      !check_time(state, {.what = "a timeout", .time = "the time to wait"}, timeout.d, ns))
    return false;
  const double seconds = limited ? timeout.d : 0.0;
  state.pending =
      std::make_unique<WaitUntil>(state, *state.code().noted->waits[pc->c], seconds, ns);
  return true;
}

bool begin_wait(VmState& state, Task& task, Slot* result, const Instr* pc) {
  if (state.pending == nullptr)  // a native function returned "paused" without pause()
    return raise(state, "R0626", {"a function of the host waits for nothing"});
  if (state.host.calls > 0) {  // the function is not declared as pausing
    state.pending->stop();
    state.pending.reset();
    return raise_may_not_pause(state);
  }
  const Frame& frame = *task.stack.top;
  Obj* condition = nullptr;
  task.waits_until = pc->op == OpCode::WAITUNTIL;
  if (task.waits_until) condition = frame.base[pc->a].o;
  if (pc > frame.callee->code && pc[-1].op == OpCode::GUARD) condition = frame.base[pc[-1].a].o;
  task.waiting = std::move(state.pending);
  task.result = result;
  task.condition = condition;
  retain_object(condition);
  if (condition != nullptr) {
    state.tree.arm(task);
  } else {
    count_wait(task, state.vm.timeline().now_ns());
  }
  if (state.is_leaving) state.steps.book(kPauseStepsLeaving);
  state.count_pause();
  return true;
}

}  // namespace armlet::lang
