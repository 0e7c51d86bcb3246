#include "vm/tasks/tasks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "armlet/interpreter/virtual_time.hpp"
#include "vm/failures/failures.hpp"
#include "vm/failures/leaving.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/tasks/busy_wait.hpp"
#include "vm/tasks/recordings.hpp"

namespace armlet::lang {

namespace {

constexpr int kMostRounds = 1000;
// The largest count of rounds at one instant in which tasks only begin and end, such as one
// parallel after another.
constexpr int kMostQuietRounds = 1'000'000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
// Conditions may become true as time passes, so the program counts as stuck only after this much
// virtual time.
constexpr std::int64_t kPatience_ns = 3600LL * 1'000'000'000LL;

bool may_continue(const Task& task) {
  if (task.has_ended) return false;
  return task.is_ready || task.came_true || task.waiting->is_over() || task.waiting->has_work();
}

// The wait of a program that has ended while its run continues.
class Rest final : public Waiting {
 public:
  [[nodiscard]] std::int64_t due_ns() const override { return kNever; }
  [[nodiscard]] bool is_over() const override { return is_stopped_; }
  void stop() override { is_stopped_ = true; }
  Signal finish(Vm&, Slot&) override { return Signal::kDone; }
  [[nodiscard]] std::string what() const override { return "its host"; }

 private:
  bool is_stopped_ = false;
};

// Whether the next action of the task follows from the text alone: it begins, or the tasks that it
// started have ended.
bool is_quiet(const Task& task) {
  const bool is_triggered = task.origin.watch != nullptr && task.origin.watch->condition != nullptr;
  return task.is_ready ? !is_triggered : task.waits_for_its_tasks();
}

}  // namespace

Exit Scheduler::go_on(std::int64_t until_ns) {
  until_ns_ = until_ns;
  Exit exit = Exit::kPaused;
  while (exit == Exit::kPaused) exit = do_stage();
  if (exit != Exit::kSliced) end();
  return exit;
}

Exit Scheduler::do_stage() {
  switch (stage_) {
    case Stage::kBegin:
      return begin_program();
    case Stage::kProgram:
      return run_program();
    case Stage::kInstant:
      begin_instant();
      return Exit::kPaused;
    case Stage::kRound:
      begin_round();
      return Exit::kPaused;
    case Stage::kTasks:
      return run_tasks() ? finish_round() : Exit::kSliced;
    case Stage::kTime:
      return pass_time();
  }
  return Exit::kFailed;
}

Exit Scheduler::begin_program() {
  stage_ = Stage::kProgram;
  state_.running = &state_.main;
  if (!state_.enter(function_, nullptr)) return Exit::kFailed;
  std::ranges::copy(arguments_, state_.main.stack.top->base);
  return Exit::kPaused;
}

Exit Scheduler::run_program() {
  const Exit exit = finished(interpret_on(state_.main));
  if (exit == Exit::kPaused) stage_ = Stage::kInstant;
  return exit;
}

// kPaused instead of kDone: an entry has reached the end of its text and waits for its tasks.
Exit Scheduler::finished(Exit exit) {
  if (exit != Exit::kDone) return exit;
  while (state_.main.stack.top > state_.main.stack.frames) leave_frame(state_, state_.main);
  if (state_.options.stays && !state_.programs.newest->entry.is_one) {
    state_.main.waiting = std::make_unique<Rest>();
    is_resting_ = true;
    return Exit::kPaused;
  }
  return !state_.programs.newest->entry.is_one || end_entry(state_) ? Exit::kDone : Exit::kPaused;
}

void Scheduler::begin_started() {
  if (stage_ != Stage::kTime) return;  // it will be evaluated later in this instant
  target_ns_.reset();
  pass_ = {};
  stage_ = Stage::kTasks;
}

void Scheduler::end() {
  is_resting_ = false;
  if (state_.programs.newest->entry.is_one) {
    tree_.rest();
  } else {
    tree_.abandon(state_.main);
  }
  tree_.sweep();
  tree_.report_skipped();
  state_.running = &state_.main;
}

void Scheduler::begin_instant() {
  if (state_.recordings != nullptr) {
    state_.recordings->take_due(
        [this](Task& task) { tree_.interrupt(task, std::move(state_.fault)); });
  }
  rounds_ = quiet_ = failures_ = 0;
  stage_ = Stage::kRound;
}

void Scheduler::begin_round() {
  evaluate_conditions();
  pass_ = {};
  stage_ = Stage::kTasks;
}

Exit Scheduler::finish_round() {
  tree_.sweep();
  const Exit exit = finished(pass_.exit);
  if (exit != Exit::kPaused) return exit;
  stage_ = pass_.progress ? Stage::kRound : Stage::kTime;
  if (!pass_.progress) return Exit::kPaused;
  if (pass_.changed) ++rounds_;
  if (rounds_ < kMostRounds && ++quiet_ < kMostQuietRounds) return Exit::kPaused;
  if (++failures_ > 2) return abandon();
  if (Task* busy = find_busy_task(state_, kMostRounds / 2)) {
    raise_busy_wait(state_, *busy, std::max(rounds_, quiet_));
    tree_.interrupt(*busy, std::move(state_.fault));
  } else {
    fail_everywhere({"R0620", {std::to_string(std::max(rounds_, quiet_))}}, {});
  }
  rounds_ = quiet_ = 0;
  return Exit::kPaused;
}

void Scheduler::evaluate_conditions() {
  for (auto next = tree_.armed().begin(); next != tree_.armed().end();) {
    const auto [order, armed] = *next;
    if (armed.task != nullptr) {
      evaluate(*armed.task);
    } else if (armed.watch->condition != nullptr) {
      evaluate(*armed.watch);
    }
    if (state_.is_leaving) state_.steps.book(kLookStepsLeaving);
    state_.count_pause();
    next = tree_.armed().upper_bound(order);
  }
}

void Scheduler::evaluate(Task& task) {
  bool is_true = false;
  if (!state_.evaluate(task, task.condition, is_true)) {
    tree_.interrupt(task, std::move(state_.fault));
  } else if (task.waits_until) {
    task.came_true = is_true;
  } else if (is_true) {
    tree_.disarm(task);
    task.waiting->stop();
  }
}

bool Scheduler::still_holds(Task& task) {
  evaluate(task);
  state_.count_pause();
  // The condition failed; its failure is raised now.
  if (task.interrupted != nullptr) return true;
  if (task.came_true) task.waiting->stop();
  return task.waiting->is_over();
}

bool Scheduler::still_triggered(Task& body) {
  Watch& watch = *body.origin.watch;
  const bool was_evaluated = state_.evaluate(*watch.owner, watch.condition, watch.was_true);
  state_.count_pause();
  if (was_evaluated && watch.was_true) return true;
  const FaultPtr fault = std::move(state_.fault);
  tree_.end(body, nullptr);
  if (!was_evaluated) tree_.fail_block(watch, fault);
  // A block at its end may have waited for this body only.
  if (may_continue(*watch.owner)) pass_.progress = true;
  return false;
}

bool Scheduler::has_turn(Task& task) {
  if (!may_continue(task)) return false;
  if (task.came_true) return still_holds(task);
  const bool is_triggered =
      task.is_ready && task.origin.watch != nullptr && task.origin.watch->condition != nullptr;
  return !is_triggered || still_triggered(task);
}

// A condition that becomes true while the body runs is ignored.
void Scheduler::evaluate(Watch& watch) {
  const bool was_true = watch.was_true;
  const bool failed =
      !state_.evaluate(*watch.owner, watch.condition, watch.was_true) ||
      (watch.was_true && !was_true && watch.running == nullptr && !tree_.start(watch));
  if (failed) tree_.fail_block(watch, std::move(state_.fault));
}

// Runs tasks in the order of their creation. Tasks that begin meanwhile run last.
bool Scheduler::run_tasks() {
  do {
    for (; pass_.next <= tree_.all().size(); ++pass_.next) {
      Task& task = pass_.next == 0 ? state_.main : *tree_.all()[pass_.next - 1];
      if (!pass_.inside && !has_turn(task)) continue;
      const Exit exit = run(task);
      pass_.inside = exit == Exit::kSliced;
      if (pass_.inside) return false;
      if (exit == Exit::kPaused) continue;
      if (pass_.next == 0) {
        pass_.exit = exit;
        return true;
      }
      tree_.end(task, exit == Exit::kFailed ? std::move(state_.fault) : nullptr);
    }
  } while (tree_.start_beats());
  return true;
}

Exit Scheduler::run(Task& task) {
  if (pass_.inside) return interpret_on(task);
  pass_.progress = true;
  pass_.changed = pass_.changed || !is_quiet(task);
  if (task.is_ready) return begin(task);
  return task.waiting->is_over() ? resume(task) : work(task);
}

// The task continues to wait.
Exit Scheduler::work(Task& task) {
  state_.running = &task;
  state_.count_pause();
  bool done = false;
  try {
    done = task.waiting->work(state_.vm) || require_failure(state_);
  } catch (...) {
    raise_thrown(state_, task);
  }
  if (!done) tree_.interrupt(task, std::move(state_.fault));
  return Exit::kPaused;
}

Exit Scheduler::interpret_on(Task& task) {
  const Left left = interpret(state_, task, last_);
  last_ = left.result;
  return left.exit;
}

Exit Scheduler::begin(Task& task) {
  task.is_ready = false;
  state_.running = &task;
  resumed_ns_ = state_.vm.timeline().now_ns();
  state_.count_pause();
  auto* closure = static_cast<ClosureObj*>(task.origin.entry);
  if (!state_.enter(closure->function, closure)) return Exit::kFailed;
  return interpret_on(task);
}

Exit Scheduler::resume(Task& task) {
  const std::unique_ptr<Waiting> waiting = std::move(task.waiting);
  tree_.disarm(task);
  state_.running = &task;
  state_.count_pause();
  resumed_ns_ = state_.vm.timeline().now_ns();
  FaultPtr fault = std::move(task.interrupted);
  if (std::exchange(task.children.joins, false)) {
    task.children.branches.clear();
    FaultPtr branch = std::move(task.children.branch_fault);
    if (branch != nullptr && (fault == nullptr || !outranks(*fault, *branch)))
      fault = std::move(branch);
  }
  const std::size_t ending = std::exchange(task.children.ending, kNoRegion);
  const bool is_end_of_entry =
      &task == &state_.main && ending == 0 && state_.programs.newest->entry.is_one;
  if (ending != kNoRegion && !is_end_of_entry) tree_.close_regions(task, ending);
  Slot nowhere{.i = 0};
  bool failed = fault != nullptr;
  if (failed) {
    state_.fault = std::move(fault);
  } else {
    Slot& result = task.result != nullptr ? *task.result : nowhere;
    failed = !finish(*waiting, result);
  }
  if (failed && !unwind(state_, task)) return Exit::kFailed;
  return interpret_on(task);
}

bool Scheduler::finish(Waiting& waiting, Slot& result) {
  try {
    return waiting.finish(state_.vm, result) == Signal::kDone || require_failure(state_);
  } catch (...) {
    raise_thrown(state_, *state_.running);
  }
  return false;
}

std::int64_t Scheduler::next_instant() const {
  const Timeline& timeline = state_.vm.timeline();
  const std::int64_t now = timeline.now_ns();
  const std::int64_t tick = std::max<std::int64_t>(timeline.tick_ns(), 1);
  const std::int64_t next_tick = (now / tick + 1) * tick;
  std::int64_t next = kNever;
  const auto look_at = [&](std::int64_t due) {
    next = std::min(next, due > now ? due : next_tick);
  };
  look_at(state_.main.waiting->due_ns());
  for (const auto& task : tree_.all()) look_at(task->waiting->due_ns());
  bool armed = false;
  for (const auto& [order, one] : tree_.armed()) {
    const bool beats = one.watch != nullptr && one.watch->condition == nullptr;
    armed = armed || !beats;
    if (beats && one.watch->running == nullptr) look_at(one.watch->next_ns);
  }
  if (armed && (next != kNever || now - resumed_ns_ < kPatience_ns))
    next = std::min(next, next_tick);
  // A recording alone cannot change the state of the program.
  if (next != kNever && state_.recordings != nullptr)
    next = std::min(next, state_.recordings->next_ns());
  return next;
}

// The world moves to the instant as a whole, without a stop in between.
bool Scheduler::advance_to(std::int64_t t_ns) {
  const Supervised nobody(nullptr);
  return state_.vm.timeline().advance_to(t_ns);
}

// In a replay: the instant of the next recorded stop request.
std::int64_t Scheduler::next_cancellation() const {
  const std::vector<Cancellation>& due = state_.cancellations.due;
  const std::int64_t now = state_.vm.timeline().now_ns();
  return due.empty() || due.back().at.t_ns <= now ? kNever : due.back().at.t_ns;
}

std::optional<std::int64_t> Scheduler::choose_instant() {
  if (is_at_rest()) return std::min(until_ns_, state_.options.limits.time_ns);
  const std::int64_t next = next_instant();
  if (next == kNever) {
    fail_everywhere(Headline("R0621"), waited_for());
    return std::nullopt;
  }
  if (next > state_.options.limits.time_ns) {
    const std::string left = quantity_text(time_left(state_.vm), dims::kTime);
    fail_everywhere({"R0636", {"what the program waits for", left}}, waited_for());
    return std::nullopt;
  }
  return next;
}

// The host may let less time pass than requested, and a slice may end between two instants. No task
// runs there, and the remaining time is requested later.
Exit Scheduler::pass_time() {
  const auto leave_for = [this](Stage stage) {
    target_ns_.reset();
    stage_ = stage;
  };
  if (state_.take_cancellation()) {
    leave_for(Stage::kInstant);
    return stop();
  }
  if (is_at_rest() && until_ns_ == kNever) return Exit::kSliced;
  if (!target_ns_) target_ns_ = choose_instant();
  if (!target_ns_) {
    stage_ = Stage::kInstant;
    return Exit::kPaused;
  }
  const Timeline& timeline = state_.vm.timeline();
  if (state_.steps.slice_is_over() || timeline.now_ns() >= until_ns_) return Exit::kSliced;
  try {
    if (advance_to(std::min({*target_ns_, until_ns_, next_cancellation()}))) {
      if (timeline.now_ns() >= *target_ns_) leave_for(Stage::kInstant);
      return Exit::kPaused;
    }
  } catch (...) {
    leave_for(Stage::kInstant);
    if (state_.is_leaving) return abandon();
    raise_thrown(state_, state_.main);
    tree_.interrupt(state_.main, std::move(state_.fault));
    return Exit::kPaused;
  }
  ++state_.cancellations.refusals;
  leave_for(Stage::kInstant);
  return state_.is_leaving ? abandon() : stop();
}

// Executes a stop request: cancels the program.
Exit Scheduler::stop() {
  state_.running = &state_.main;
  raise_cancelled(state_);
  if (is_resting_) {
    const FaultPtr fault = std::move(state_.fault);
    for (const auto& task : tree_.all())
      if (!task->origin.started_as.empty() && !task->has_ended) tree_.interrupt(*task, fault);
    if (tree_.all().empty()) state_.reopen();
    return Exit::kPaused;
  }
  tree_.interrupt(state_.main, std::move(state_.fault));
  return Exit::kPaused;
}

// Time cannot pass any more, so nothing can be brought to a controlled stop.
Exit Scheduler::abandon() {
  Task& task = state_.main;
  state_.running = &task;
  raise_cancelled(state_);
  state_.fault->reach = Reach::kNothing;
  tree_.abandon(task);
  task.waiting.reset();
  tree_.disarm(task);
  (void)unwind(state_, task);
  return Exit::kFailed;
}

// Raises the failure in the program. If the program is being stopped already, raises it in the
// tasks that still wait.
void Scheduler::fail_everywhere(const Headline& headline, std::string why) {
  std::vector<Task*> victims;
  if (state_.main.interrupted == nullptr && !is_resting_) {
    victims.push_back(&state_.main);
  } else {
    for (const auto& task : tree_.all()) {
      if (!task->has_ended && !task->is_ready && !task->waits_for_its_tasks())
        victims.push_back(task.get());
    }
  }
  for (Task* task : victims) {
    state_.running = task;
    Diagnostic failure = start_failure(state_, headline);
    failure.why = why;
    raise(state_, std::move(failure));
    tree_.interrupt(*task, std::move(state_.fault));
  }
}

std::string Scheduler::waited_for() const {
  std::string text;
  const auto add = [&](const Task& task) {
    if (task.waits_for_its_tasks()) return;
    if (!text.empty()) text += '\n';
    const std::string name = task_name(task);
    text += (name.empty() ? "the program" : name) + " waits for " + task.waiting->what();
  };
  if (!is_resting_) add(state_.main);
  for (const auto& task : tree_.all()) add(*task);
  return text;
}

}  // namespace armlet::lang
