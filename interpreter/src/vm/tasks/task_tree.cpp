#include "vm/state/task_tree.hpp"

#include <new>

#include "vm/failures/failures.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kMostSpare = 64;

std::size_t slots_for(std::uint32_t call_depth) {
  return std::size_t{64} * 1024 + std::size_t{call_depth} * 32;
}

// The fault that ends a cancelled task. No message shows it.
FaultPtr cancellation(Reach reach) {
  auto fault = std::make_shared<Fault>();
  fault->diagnostic.code = "R0629";
  fault->reach = reach;
  return fault;
}

// A copy of the fault of a task for the task that waits for it.
FaultPtr carried_over(const FaultPtr& fault) {
  if (fault->is_leaving || fault->reach == Reach::kHandlers) return fault;
  auto out = std::make_shared<Fault>(*fault);
  out->reach = Reach::kHandlers;
  out->region = kNoRegion;
  return out;
}

void make_new(Task& task) {
  task.result = nullptr;
  task.origin.function = nullptr;
  task.origin.parent = nullptr;
  task.origin.watch = nullptr;
  task.origin.started_as.clear();
  task.origin.depth = 0;
  task.is_ready = task.has_ended = task.is_cancelled = task.children.joins = false;
  task.parallels = 0;
  task.children.branches.clear();
  task.children.alive = 0;
  task.children.branch_fault.reset();
  task.children.ending = kNoRegion;
}

}  // namespace

bool outranks(const Fault& a, const Fault& b) {
  if (a.reach != b.reach) return a.reach > b.reach;
  if (a.is_leaving != b.is_leaving) return a.is_leaving;
  // An outer region has priority; kNoRegion is outside of all.
  return a.region + 1 < b.region + 1;
}

Task* TaskTree::create(Task& parent, Obj* closure) {
  const auto too_many = [&](std::string how) -> Task* {
    raise(state_, "R0633", {std::move(how)});
    return nullptr;
  };
  if (alive_ >= kMostTasks)
    return too_many("more than " + std::to_string(kMostTasks) + " at the same time");
  if (parent.origin.depth >= kDeepest)
    return too_many("tasks start tasks more than " + std::to_string(kDeepest) + " deep");
  const bool fits = state_.heap.charge(kFirstBytes);
  std::unique_ptr<Task> task;
  try {
    if (tasks_.size() == tasks_.capacity()) tasks_.reserve(2 * tasks_.size() + 8);
    const std::uint32_t depth = state_.options.limits.call_depth;
    if (fits && spare_.empty()) {
      task = std::make_unique<Task>(depth, slots_for(depth));
    } else if (fits) {
      task = std::move(spare_.back());
      spare_.pop_back();
    }
  } catch (const std::bad_alloc&) {
    if (fits) state_.heap.discharge(kFirstBytes);
  }
  if (task == nullptr) {
    raise_out_of_memory(state_);
    return nullptr;
  }
  make_new(*task);
  task->origin.entry = closure;
  retain_object(closure);
  task->origin.function =
      state_.programs.callees[static_cast<ClosureObj*>(closure)->function].function->function;
  task->origin.parent = &parent;
  task->host_data = parent.host_data;
  task->origin.depth = parent.origin.depth + 1;
  task->is_ready = true;
  ++alive_;
  tasks_.push_back(std::move(task));
  return tasks_.back().get();
}

void TaskTree::end(Task& task, FaultPtr fault) {
  task.has_ended = true;
  --alive_;
  if (state_.running == &task) state_.running = &state_.main;
  disarm(task);
  task.waiting.reset();
  task.interrupted.reset();
  while (task.stack.top > task.stack.frames) leave_frame(state_, task);
  abandon(task);
  state_.heap.release(task.origin.entry);
  task.origin.entry = nullptr;
  state_.heap.discharge(kFirstBytes);
  task.stack.shrink(state_.heap);
  const bool counts = fault != nullptr && (!task.is_cancelled || fault->is_leaving);
  if (!task.origin.started_as.empty()) {
    end_started(task, std::move(fault));
  } else if (Watch* watch = task.origin.watch) {
    skip_beats(*watch);
    watch->running = nullptr;
    if (counts) fail_block(*watch, fault);
  } else {
    task.origin.parent->children.branches[task.origin.place] = nullptr;
    --task.origin.parent->children.alive;
    if (counts) fail_parallel(*task.origin.parent, fault);
  }
}

Task* TaskTree::create_started(Obj* closure, std::string_view variable) {
  Task* task = create(state_.main, closure);
  if (task == nullptr) return nullptr;
  task->origin.started_as = variable;
  task->origin.started_ns = state_.vm.timeline().now_ns();
  task->host_data.reset();
  // The first task of the host gets other random numbers than the branches of the program.
  task->random = state_.main.random.split(~std::uint64_t{0}).split(state_.host.started++);
  return task;
}

void TaskTree::cancel_started() {
  for (const auto& task : tasks_)
    if (!task->origin.started_as.empty()) cancel(*task, Reach::kFinally);
}

// A failure of such a task ends only the task itself, unless the fault ends the whole program.
void TaskTree::end_started(Task& task, FaultPtr fault) {
  if (state_.options.on_task_end) {
    state_.options.on_task_end({.variable = task.origin.started_as,
                                .start_ns = task.origin.started_ns,
                                .end_ns = state_.vm.timeline().now_ns(),
                                .failure = fault == nullptr ? nullptr : &fault->diagnostic});
  }
  if (fault == nullptr || !fault->is_leaving) return;
  if (state_.scheduler->is_resting()) {
    state_.reopen();
  } else {
    interrupt(state_.main, std::move(fault));
  }
}

void TaskTree::fail_parallel(Task& parent, const FaultPtr& fault) {
  const bool is_first = parent.children.branch_fault == nullptr;
  if (is_first || outranks(*fault, *parent.children.branch_fault))
    parent.children.branch_fault = carried_over(fault);
  if (is_first || fault->reach == Reach::kNothing) cancel_branches(parent, fault->reach);
}

void TaskTree::interrupt(Task& task, FaultPtr fault) {
  disarm(task);
  const Reach reach = fault->reach;
  const std::size_t from = fault->region == kNoRegion ? 0 : fault->region;
  if (task.interrupted == nullptr || outranks(*fault, *task.interrupted))
    task.interrupted = std::move(fault);
  cancel_branches(task, reach);
  if (&task == &state_.main && reach != Reach::kHandlers && from == 0) cancel_started();
  if (reach != Reach::kHandlers) {
    stop_watching(task, from);
    cancel_bodies(task, from, reach);
  }
  if (task.waiting != nullptr) task.waiting->stop();
}

void TaskTree::cancel(Task& task, Reach reach) {
  if (task.has_ended || (task.is_cancelled && reach != Reach::kNothing)) return;
  task.is_cancelled = true;
  if (task.is_ready) {
    end(task, nullptr);
  } else {
    interrupt(task, cancellation(reach));
  }
}

void TaskTree::cancel_branches(Task& task, Reach reach) {
  const Reach how = reach == Reach::kHandlers ? Reach::kFinally : reach;
  for (Task* branch : task.children.branches) {
    if (branch != nullptr) cancel(*branch, how);
  }
}

void TaskTree::kill(Task& task) {
  task.is_cancelled = true;
  if (task.waiting != nullptr) task.waiting->stop();
  end(task, nullptr);
}

void TaskTree::abandon(Task& task) {
  end_at_once(task);
  close_regions(task, 0);
}

void TaskTree::rest() {
  end_at_once(state_.main);
  close_regions(state_.main, 1);
}

void TaskTree::end_at_once(Task& task) {
  if (&task == &state_.main) {
    for (const auto& other : tasks_)
      if (!other->origin.started_as.empty() && !other->has_ended) kill(*other);
  }
  for (Task* branch : task.children.branches) {
    if (branch != nullptr) kill(*branch);
  }
  for (const Region& region : task.children.regions) {
    for (const auto& watch : region) {
      if (watch->running != nullptr) kill(*watch->running);
    }
  }
  stop_watching(task, 0);
  for (Obj* closure : task.children.nursery) state_.heap.release(closure);
  task.children.nursery.clear();
}

void TaskTree::sweep() {
  std::erase_if(tasks_, [this](std::unique_ptr<Task>& task) {
    if (!task->has_ended) return false;
    if (spare_.size() < kMostSpare) spare_.push_back(std::move(task));
    return true;
  });
}

void TaskTree::clear() {
  Task& program = state_.main;
  abandon(program);
  disarm(program);
  program.waiting.reset();
  program.interrupted.reset();
  program.children.branch_fault.reset();
  tasks_.clear();
  spare_.clear();
}

}  // namespace armlet::lang
