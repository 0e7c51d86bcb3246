#include "armlet/interpreter/host/inspection.hpp"

#include <algorithm>
#include <string>

#include "armlet/core/error.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/host/access.hpp"
#include "vm/host/seen.hpp"
#include "vm/state/turn.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet {

namespace lang {

constexpr std::size_t kLongest = 200;  // characters of a shown value

std::string seen_text(Slot value, const Type& type) {
  std::string text = value_text(value, type, kLongest);
  if (text.size() <= kLongest) return text;
  text.resize(whole_characters(text, kLongest).size());
  return text + "...";
}

void require_seen(const VmState& state) {
  if (state.scheduler == nullptr)
    throw ArgumentError("The program has not run yet, so there is nothing to look at.");
}

Frame as_it_stands(const VmState& state, const Task& task, const Frame& frame) {
  Frame at = frame;
  if (&frame == task.stack.top && state.marks.paused == &task) ++at.pc;
  return at;
}

Span span_of(const Frame& frame) {
  const CodeSpan* span = code_span(frame);
  return span == nullptr ? Span{} : span->span;
}

bool find_value(const ScopedVariable& each, const Frame& frame, Span at, Slot& value) {
  const Span& scope = each.scope;
  if (frame.at() < each.begin || frame.at() >= each.end) return false;
  if (scope.source != at.source || at.begin < scope.begin || at.begin >= scope.end) return false;
  value = frame.base[each.reg];
  if (each.variable->storage != hir::Storage::kBoxed) return true;
  if (value.o == nullptr) return false;
  value = static_cast<const BoxObj*>(value.o)->value;
  return true;
}

}  // namespace lang

namespace {

// A null reference: the value was moved at its last use.
SeenVariable seen(const lang::hir::Variable& variable, Slot value) {
  const bool is_there = !variable.type->is_reference() || value.o != nullptr;
  return {std::string(variable.name), type_name(variable.type),
          is_there ? lang::seen_text(value, *variable.type) : std::string(), variable.declared};
}

// at  the span of the frame's current statement.
std::vector<SeenVariable> seen_variables(const lang::Frame& frame, Span at) {
  std::vector<SeenVariable> out;
  for (const lang::ScopedVariable& each : frame.callee->function->scopes) {
    Slot value{.i = 0};
    if (lang::find_value(each, frame, at, value)) out.push_back(seen(*each.variable, value));
  }
  return out;
}

SeenTask seen(const lang::VmState& state, const lang::Task& task) {
  SeenTask out;
  out.name = lang::task_name(task);
  if (task.waiting != nullptr && !task.waits_for_its_tasks()) out.waits = task.waiting->what();
  for (const lang::Frame* frame = task.stack.top; frame > task.stack.frames; --frame) {
    if (frame->is_host()) continue;
    const lang::Frame at = lang::as_it_stands(state, task, *frame);
    const Span here = lang::span_of(at);
    const lang::hir::Function* function = frame->callee->function->function;
    const bool is_block = function != nullptr && function->is_task;
    out.calls.push_back(
        {is_block ? std::string() : frame->callee->function->name, here, seen_variables(at, here)});
  }
  return out;
}

}  // namespace

std::vector<SeenVariable> seen_variables(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  lang::require_seen(state);
  std::vector<SeenVariable> out;
  for (const lang::hir::Variable* variable : lang::open_globals(state)) {
    const bool is_set = state.globals.is_set[variable->index] != 0;
    out.push_back({std::string(variable->name), type_name(variable->type),
                   is_set ? lang::seen_text(state.globals.values[variable->index], *variable->type)
                          : std::string(),
                   variable->declared});
  }
  std::ranges::reverse(out);  // from the newest first to the order of the text
  return out;
}

std::vector<SeenTask> seen_tasks(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  lang::require_seen(state);
  std::vector<SeenTask> out;
  if (vm.result().status != Progress::kPaused) return out;
  out.push_back(seen(state, state.main));
  for (const auto& task : state.tree.all()) {
    if (!task->has_ended) out.push_back(seen(state, *task));
  }
  return out;
}

namespace {

Span place_of(const lang::VmState& state, const lang::Task& task) {
  const lang::Frame* frame = task.stack.top;
  while (frame > task.stack.frames && frame->is_host()) --frame;
  return frame->is_host() ? Span{} : lang::span_of(lang::as_it_stands(state, task, *frame));
}

}  // namespace

namespace {

// A task that the host has started has the name of the variable with its function.
std::string name_of(const lang::Task& task) {
  return task.origin.started_as.empty() ? lang::task_name(task) : task.origin.started_as;
}

}  // namespace

std::vector<TaskPlace> task_places(Vm& vm) {
  const lang::VmState& state = vm.state();
  std::vector<TaskPlace> out;
  if (state.scheduler == nullptr) return out;
  out.push_back({lang::task_name(state.main), place_of(state, state.main)});
  for (const auto& task : state.tree.all())
    if (!task->has_ended) out.push_back({name_of(*task), place_of(state, *task)});
  return out;
}

Span running_at(Vm& vm) {
  const lang::VmState& state = vm.state();
  return place_of(state, *state.running);
}

}  // namespace armlet
