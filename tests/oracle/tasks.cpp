#include "tasks.hpp"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>

namespace armlet::oracle {

namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kTick = 1'000'000;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct Abandoned {};

}  // namespace

struct Tasks::Watch {
  Task* owner;
  std::size_t block;    // of the owner
  Condition condition;  // none: a beat
  Body body;
  std::uint64_t order = 0;  // of arming; 0: it has stopped
  bool was_true = false;
  std::int64_t period = 0;
  std::int64_t next = 0;  // beat that has been neither begun nor skipped
  Task* running = nullptr;
};

struct Tasks::Task {
  Task(Body what, Task* from, Watch* of) : body(std::move(what)), parent(from), watch(of) {}

  Body body;
  Task* parent;
  Watch* watch;  // whose body it is; null: a branch, or the program
  std::thread thread{};
  std::binary_semaphore turn{0};
  bool has_begun = false;
  bool has_ended = false;
  bool is_cancelled = false;  // how it ends is nobody's business
  std::optional<Failure> failure{};

  // ---- what it waits for
  std::int64_t due = kNever;
  Condition condition{};
  std::uint64_t order = 0;  // of arming
  bool is_over = false;
  bool came_true = false;       // at this instant
  bool joins = false;           // all its branches
  std::size_t closing = kNone;  // the bodies of this block and those inside
  std::optional<Raised> raised{};

  // ---- what it has started
  std::vector<Task*> branches{};  // that have not ended
  std::optional<Failure> branch_failure{};
  std::vector<std::vector<std::unique_ptr<Watch>>> blocks{};

  [[nodiscard]] bool has_bodies(std::size_t from) const {
    for (std::size_t i = from; i < blocks.size(); ++i) {
      for (const auto& one : blocks[i]) {
        if (one->running != nullptr) return true;
      }
    }
    return false;
  }
};

Tasks::Tasks() = default;

Tasks::~Tasks() {
  abandoned_ = true;
  for (const auto& task : tasks_) {
    if (!task->thread.joinable()) continue;
    if (!task->has_ended) task->turn.release();
    task->thread.join();
  }
}

// ---- the order of things

// The program runs as far as it gets by itself; from then on there are rounds.
void Tasks::run(Body program) {
  Task& main = create(std::move(program), nullptr, nullptr);
  give_turn(main);
  for (at_one_instant(); !main.has_ended; at_one_instant()) now_ = next_instant();
  if (main.failure) throw Failure(*main.failure);
}

// Conditions, then tasks, until nothing changes.
void Tasks::at_one_instant() {
  do {
    look_at_conditions();
  } while (continue_tasks());
}

void Tasks::look_at_conditions() {
  for (auto next = armed_.begin(); next != armed_.end();) {
    const auto [order, armed] = *next;
    Task* task = armed.task;
    Watch* watch = armed.watch;
    try {
      if (task != nullptr) {
        task->came_true = task->condition();
      } else if (watch != nullptr && watch->condition) {
        const bool was_true = std::exchange(watch->was_true, false);
        watch->was_true = watch->condition();
        // What comes true while the body runs is dropped.
        if (watch->was_true && !was_true && watch->running == nullptr)
          watch->running = &create(watch->body, watch->owner, watch);
      }
    } catch (const Failure& failure) {
      if (task != nullptr) interrupt(*task, {Raised::kError, failure});
      if (watch != nullptr) raise_in_block(*watch, failure);
    }
    next = armed_.upper_bound(order);
  }
}

// In the order of creation; those that are created meanwhile come last, and the bodies of beats
// after them.
bool Tasks::continue_tasks() {
  bool any = false;
  std::size_t next = 0;
  do {
    for (; next < tasks_.size(); ++next) {
      Task& task = *tasks_[next];
      if (!has_turn(task, any)) continue;
      any = true;
      give_turn(task);
      if (task.has_ended) ended(task);
    }
  } while (begin_beats());
  std::erase_if(tasks_, [](const auto& task) { return task->has_ended && task->parent; });
  return any && !tasks_.front()->has_ended;
}

// What came true goes on only if it still holds when the scheduler reaches it.
bool Tasks::has_turn(Task& task, bool& any) {
  if (!may_continue(task)) return false;
  Watch* watch = task.watch;
  try {
    if (task.came_true && !task.is_over) {
      task.came_true = task.condition();
    } else if (!task.has_begun && watch != nullptr && watch->condition) {
      watch->was_true = watch->condition();
      if (watch->was_true) return true;
      drop(task);
      any = any || may_continue(*watch->owner);
      return false;
    }
  } catch (const Failure& failure) {
    any = true;
    if (task.has_begun) {
      interrupt(task, {Raised::kError, failure});
    } else {
      drop(task);
      raise_in_block(*watch, failure);
      return false;
    }
  }
  return may_continue(task);
}

void Tasks::drop(Task& task) {
  task.has_ended = true;
  ended(task);
}

bool Tasks::begin_beats() {
  bool any = false;
  for (const auto& [order, armed] : std::map(armed_)) {
    Watch* watch = armed.watch;
    const bool beats = watch != nullptr && !watch->condition && watch->running == nullptr;
    if (!beats || watch->next > now_) continue;
    any = true;
    watch->next += watch->period;
    watch->running = &create(watch->body, watch->owner, watch);
  }
  return any;
}

std::int64_t Tasks::next_instant() const {
  std::int64_t next = kNever;
  for (const auto& task : tasks_) next = std::min(next, task->due);
  const std::int64_t tick = (now_ / kTick + 1) * kTick;
  for (const auto& [order, armed] : armed_) {
    const bool beats = armed.watch != nullptr && !armed.watch->condition;
    if (!beats) next = std::min(next, tick);
    if (beats && armed.watch->running == nullptr) next = std::min(next, armed.watch->next);
  }
  if (next == kNever) throw std::logic_error("all tasks wait for each other");
  return next;
}

bool Tasks::may_continue(const Task& task) const {
  if (task.has_ended) return false;
  if (!task.has_begun) return true;
  if (task.joins) return task.branches.empty();
  if (task.closing != kNone) return !task.has_bodies(task.closing);
  return task.is_over || task.came_true || now_ >= task.due;
}

void Tasks::give_turn(Task& task) {
  running_ = &task;
  if (!std::exchange(task.has_begun, true)) {
    task.thread = std::thread([this, &task] {
      try {
        task.body();
      } catch (const Failure& failure) {
        task.failure = failure;
      } catch (const Raised&) {
        // It was cancelled.
      } catch (const Abandoned&) {
        return;
      } catch (...) {
        broken_ = std::current_exception();
      }
      task.has_ended = true;
      scheduler_.release();
    });
  } else {
    task.turn.release();
  }
  scheduler_.acquire();
  running_ = nullptr;
  if (broken_) std::rethrow_exception(broken_);
}

void Tasks::give_back() {
  Task& task = *running_;
  scheduler_.release();
  task.turn.acquire();
  if (abandoned_) throw Abandoned{};
  if (task.order != 0) armed_.erase(task.order);
  task.order = 0;
  task.due = kNever;
  task.condition = nullptr;
  task.is_over = false;
}

// ---- what a running task asks for

namespace {

void raise(std::optional<Raised> raised) {
  if (!raised) return;
  if (raised->level == Raised::kError) throw Failure(*raised->failure);
  throw Raised(*raised);
}

}  // namespace

void Tasks::sleep(std::int64_t ns) {
  Task& task = *running_;
  task.due = now_ + ns;
  give_back();
  raise(std::exchange(task.raised, {}));
}

bool Tasks::wait_until(Condition condition, std::optional<std::int64_t> timeout_ns) {
  Task& task = *running_;
  if (timeout_ns) task.due = now_ + *timeout_ns;
  task.condition = std::move(condition);
  task.order = ++last_order_;
  task.came_true = false;
  armed_[task.order] = {&task, nullptr};
  give_back();
  raise(std::exchange(task.raised, {}));
  return std::exchange(task.came_true, false);
}

// What interrupts the whole outranks the error of a branch.
void Tasks::parallel(std::vector<Body> branches) {
  Task& task = *running_;
  for (Body& body : branches) task.branches.push_back(&create(std::move(body), &task, nullptr));
  task.joins = true;
  give_back();
  task.joins = false;
  const std::optional<Failure> failure = std::exchange(task.branch_failure, {});
  raise(std::exchange(task.raised, {}));
  if (failure) throw Failure(*failure);
}

std::size_t Tasks::open_block() {
  running_->blocks.emplace_back();
  return running_->blocks.size();
}

void Tasks::watch(Condition condition, Body body) {
  Task& task = *running_;
  auto& block = task.blocks.back();
  block.push_back(std::make_unique<Watch>(
      Watch{&task, task.blocks.size() - 1, std::move(condition), std::move(body)}));
  Watch& watch = *block.back();
  watch.order = ++last_order_;
  armed_[watch.order] = {nullptr, &watch};
  watch.was_true = watch.condition();
  if (watch.was_true) watch.running = &create(watch.body, &task, &watch);
}

void Tasks::watch(std::int64_t period_ns, Body body) {
  Task& task = *running_;
  auto& block = task.blocks.back();
  block.push_back(
      std::make_unique<Watch>(Watch{&task, task.blocks.size() - 1, nullptr, std::move(body)}));
  Watch& watch = *block.back();
  watch.order = ++last_order_;
  armed_[watch.order] = {nullptr, &watch};
  watch.period = period_ns;
  watch.next = now_ + period_ns;
  watch.running = &create(watch.body, &task, &watch);
}

void Tasks::close_block(bool after_failure) {
  Task& task = *running_;
  const std::size_t block = task.blocks.size() - 1;
  stop_watching(task, block);
  if (after_failure) cancel_bodies(task, block);
  if (task.has_bodies(block)) {
    task.closing = block;
    give_back();
    task.closing = kNone;
  }
  task.blocks.resize(block);
  raise(std::exchange(task.raised, {}));
}

// ---- how tasks begin and end

Tasks::Task& Tasks::create(Body body, Task* parent, Watch* watch) {
  tasks_.push_back(std::make_unique<Task>(std::move(body), parent, watch));
  return *tasks_.back();
}

// Who waits for it learns of it. Of several errors in branches the first counts.
void Tasks::ended(Task& task) {
  if (task.thread.joinable()) task.thread.join();
  const bool counts = task.failure && !task.is_cancelled;
  if (Watch* watch = task.watch) {
    skip_beats(*watch);
    watch->running = nullptr;
    if (counts) raise_in_block(*watch, *task.failure);
  } else if (Task* parent = task.parent) {
    std::erase(parent->branches, &task);
    if (!counts || parent->branch_failure) return;
    parent->branch_failure = task.failure;
    for (Task* branch : std::vector(parent->branches)) cancel(*branch);
  }
}

// It goes on with what is raised when all that it has started and that must end has ended.
void Tasks::interrupt(Task& task, Raised raised) {
  if (!task.raised || raised.level < task.raised->level) task.raised = raised;
  for (Task* branch : std::vector(task.branches)) cancel(*branch);
  if (raised.level != Raised::kError) {
    const std::size_t from = raised.level == Raised::kWholeTask ? 0 : raised.level - 1;
    stop_watching(task, from);
    cancel_bodies(task, from);
  }
  if (task.order != 0) armed_.erase(task.order);
  task.is_over = true;
  task.came_true = false;
}

void Tasks::cancel(Task& task) {
  if (task.has_ended || std::exchange(task.is_cancelled, true)) return;
  if (task.has_begun) {
    interrupt(task, {Raised::kWholeTask, {}});
  } else {
    drop(task);
  }
}

// The error ends what the block does. A block that has come to its end only waits for its tasks, so
// there it is an error like any other.
void Tasks::raise_in_block(const Watch& watch, const Failure& failure) {
  Task& owner = *watch.owner;
  const bool is_closing = owner.closing != kNone && watch.block >= owner.closing;
  if (is_closing) cancel_bodies(owner, owner.closing);
  interrupt(owner, {is_closing ? Raised::kError : watch.block + 1, failure});
}

void Tasks::stop_watching(Task& owner, std::size_t from) {
  for (std::size_t i = from; i < owner.blocks.size(); ++i) {
    for (const auto& watch : owner.blocks[i]) {
      armed_.erase(watch->order);
      watch->order = 0;
    }
  }
}

void Tasks::cancel_bodies(const Task& owner, std::size_t from) {
  for (std::size_t i = from; i < owner.blocks.size(); ++i) {
    for (const auto& watch : owner.blocks[i]) {
      if (watch->running != nullptr) cancel(*watch->running);
    }
  }
}

// Beats that came while the body was running; not one that comes as it ends.
void Tasks::skip_beats(Watch& watch) const {
  if (watch.condition) return;
  while (watch.next < now_) watch.next += watch.period;
}

}  // namespace armlet::oracle
