// Instructions that start tasks, and that end blocks with watches.

#include <cmath>
#include <limits>

#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/values/durations.hpp"

namespace armlet::lang {

namespace {

// The wait of a task for the tasks that it has started. If the wait is stopped, those tasks are
// cancelled.
class ChildrenEnd final : public Waiting {
 public:
  ChildrenEnd(const Task& task, std::string what) : task_(task), what_(std::move(what)) {}

  [[nodiscard]] std::int64_t due_ns() const override {
    return std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] bool is_over() const override {
    return task_.children.joins ? task_.children.alive == 0
                                : !TaskTree::has_bodies(task_, task_.children.ending);
  }
  void stop() override {}
  Signal finish(Vm&, Slot&) override { return Signal::kDone; }
  [[nodiscard]] std::string what() const override { return what_; }

 private:
  const Task& task_;
  std::string what_;
};

// Ends the regions from `from` on: at once, or when their tasks have ended.
bool end_watches(VmState& state, std::size_t from) {
  Task& task = *state.running;
  if (!TaskTree::has_bodies(task, from)) {
    state.tree.close_regions(task, from);
    return true;
  }
  task.children.ending = from;
  state.pending = std::make_unique<ChildrenEnd>(task, "the tasks of a block");
  return true;
}

// Each branch has a stream of random numbers of its own: the same in every run, independent of the
// numbers that other tasks take, and a different one for each start of the branch.
Random stream_of(const Task& parent, const hir::Function& branch) {
  const std::uint64_t place = std::uint64_t{branch.span.source} << 32U | branch.span.begin;
  return parent.random.split(place).split(parent.parallels);
}

}  // namespace

bool op_spawn(VmState& state, Slot* base, const Instr* pc) {
  if (state.host.calls > 0) return raise_may_not_pause(state);
  std::vector<Obj*>& nursery = state.running->children.nursery;
  // Closures that a failure between two branches of another `parallel` has left.
  while (nursery.size() > pc->c) {
    state.heap.release(nursery.back());
    nursery.pop_back();
  }
  retain_object(base[pc->a].o);
  nursery.push_back(base[pc->a].o);
  return true;
}

bool op_parallel(VmState& state, Slot*, const Instr*) {
  Task& task = *state.running;
  task.children.branches.clear();
  task.children.branch_fault.reset();
  bool made = true;
  for (Obj* closure : task.children.nursery) {
    Task* branch = made ? state.tree.create(task, closure) : nullptr;
    made = branch != nullptr;
    if (made) {
      branch->origin.place = task.children.branches.size();
      branch->random = stream_of(task, *branch->origin.function);
      task.children.branches.push_back(branch);
      ++task.children.alive;
    }
    state.heap.release(closure);
  }
  task.children.nursery.clear();
  ++task.parallels;
  if (!made) {
    const FaultPtr fault = std::move(state.fault);
    for (Task* branch : task.children.branches) state.tree.cancel(*branch, Reach::kFinally);
    state.fault = fault;
    return false;
  }
  task.children.joins = true;
  state.pending = std::make_unique<ChildrenEnd>(task, "its branches");
  return true;
}

bool op_openwatch(VmState& state, Slot* base, const Instr* pc) {
  if (state.host.calls > 0) return raise_may_not_pause(state);
  base[pc->a].i = static_cast<std::int64_t>(state.running->children.regions.size());
  state.running->children.regions.emplace_back();
  return true;
}

bool op_watchwhen(VmState& state, Slot* base, const Instr* pc) {
  Task& task = *state.running;
  Watch& watch = state.tree.watch(task, base[pc->a].o, base[pc->b].o);
  watch.head = code_span(state)->span;
  if (!state.evaluate(task, watch.condition, watch.was_true)) return false;
  return !watch.was_true || state.tree.start(watch);
}

bool op_watchevery(VmState& state, Slot* base, const Instr* pc) {
  std::int64_t period_ns = 0;
  const TimeUse use{.what = "a beat",
                    .time = "the time between two beats",
                    .least_ns = 1,
                    .requirement = "the time between two beats must be at least 1 ns"};
  if (!check_time(state, use, base[pc->a].d, period_ns)) return false;
  Task& task = *state.running;
  Watch& watch = state.tree.watch(task, nullptr, base[pc->b].o);
  watch.head = code_span(state)->span;
  watch.period_ns = period_ns;
  watch.next_ns = state.vm.timeline().now_ns() + period_ns;
  return state.tree.start(watch);
}

bool op_endwatch(VmState& state, Slot* base, const Instr* pc) {
  const auto from = static_cast<std::size_t>(base[pc->a].i);
  state.tree.stop_watching(*state.running, from);
  return end_watches(state, from);
}

bool end_entry(VmState& state) {
  state.running = &state.main;
  state.tree.stop_watching(state.main, 0);
  if (!TaskTree::has_bodies(state.main, 0)) return true;
  state.main.children.ending = 0;
  state.main.waiting = std::make_unique<ChildrenEnd>(
      state.main, "the blocks of `when` and `every` that are running");
  return false;
}

// An error of a watch has reached the block of the watch: from here on it can be caught.
bool op_stopwatch(VmState& state, Slot* base, const Instr* pc) {
  const auto from = static_cast<std::size_t>(base[pc->a].i);
  Task& task = *state.running;
  FaultPtr& held = held_fault(base[pc->b].o);
  const Reach reach = held->reach;
  if (!held->is_leaving && held->reach == Reach::kFinally && held->region == from) {
    auto error = std::make_shared<Fault>(*held);
    error->reach = Reach::kHandlers;
    error->region = kNoRegion;
    held = std::move(error);
  }
  state.tree.stop_watching(task, from);
  state.tree.cancel_bodies(task, from,
                           reach == Reach::kNothing ? Reach::kNothing : Reach::kFinally);
  return end_watches(state, from);
}

}  // namespace armlet::lang
