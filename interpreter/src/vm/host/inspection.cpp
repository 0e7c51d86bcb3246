#include "armlet/interpreter/host/inspection.hpp"

#include <algorithm>
#include <string>

#include "armlet/core/error.hpp"
#include "format_value.hpp"
#include "vm/failures/failures.hpp"
#include "vm/host/access.hpp"
#include "vm/tasks/tasks.hpp"
#include "vm/turn.hpp"

namespace armlet {
namespace {

constexpr std::size_t kLongest = 200;  // of a value that is shown

std::string shown(Slot value, const Type& type) {
  std::string text = lang::value_text(value, type, kLongest);
  if (text.size() <= kLongest) return text;
  text.resize(whole_characters(text, kLongest).size());
  return text + "...";
}

void require_begun(const lang::VmState& state) {
  if (state.scheduler == nullptr)
    throw ArgumentError("The program has not run yet, so there is nothing to look at.");
}

// A reference that is null was given away where it was used last.
SeenVariable seen(const lang::hir::Variable& variable, Slot value) {
  const bool is_there = !variable.type->is_reference() || value.o != nullptr;
  return {std::string(variable.name), type_name(variable.type),
          is_there ? shown(value, *variable.type) : std::string(), variable.declared};
}

// at   what the frame has come to in the text.
// pc   and in the code.
std::vector<SeenVariable> seen_variables(const lang::Frame& frame, Span at, std::uint32_t pc) {
  std::vector<SeenVariable> out;
  for (const lang::ScopedVariable& each : frame.callee->function->scopes) {
    const Span& scope = each.scope;
    if (pc < each.begin || pc >= each.end) continue;
    if (scope.source != at.source || at.begin < scope.begin || at.begin >= scope.end) continue;
    Slot value = frame.base[each.reg];
    if (each.variable->storage == lang::hir::Storage::kBoxed) {
      if (value.o == nullptr) continue;
      value = static_cast<const BoxObj*>(value.o)->value;
    }
    out.push_back(seen(*each.variable, value));
  }
  return out;
}

// The frame as it stands: before the statement that begins next, if the task has paused there.
lang::Frame as_it_stands(const lang::VmState& state, const lang::Task& task,
                         const lang::Frame& frame) {
  lang::Frame at = frame;
  if (&frame == task.stack.top && state.marks.paused == &task) ++at.pc;
  return at;
}

Span span_of(const lang::Frame& frame) {
  const lang::CodeSpan* span = lang::code_span(frame);
  return span == nullptr ? Span{} : span->span;
}

SeenTask seen(const lang::VmState& state, const lang::Task& task) {
  SeenTask out;
  out.name = lang::task_name(task);
  if (task.waiting != nullptr && !task.waits_for_its_tasks()) out.waits = task.waiting->what();
  for (const lang::Frame* frame = task.stack.top; frame > task.stack.frames; --frame) {
    if (frame->is_host()) continue;
    const lang::Frame at = as_it_stands(state, task, *frame);
    const Span here = span_of(at);
    const lang::hir::Function* function = frame->callee->function->function;
    const bool is_block = function != nullptr && function->is_task;
    out.calls.push_back({is_block ? std::string() : frame->callee->function->name, here,
                         seen_variables(at, here, at.at())});
  }
  return out;
}

}  // namespace

std::vector<SeenVariable> seen_variables(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  require_begun(state);
  std::vector<SeenVariable> out;
  for (const lang::hir::Variable* variable : lang::open_globals(state)) {
    const bool is_set = state.globals.is_set[variable->index] != 0;
    out.push_back(
        {std::string(variable->name), type_name(variable->type),
         is_set ? shown(state.globals.values[variable->index], *variable->type) : std::string(),
         variable->declared});
  }
  std::ranges::reverse(out);  // the newest came first
  return out;
}

std::vector<SeenTask> seen_tasks(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  require_begun(state);
  std::vector<SeenTask> out;
  if (vm.result().status != Progress::kPaused) return out;
  out.push_back(seen(state, state.main));
  for (const auto& task : state.tree.all()) {
    if (!task->has_ended) out.push_back(seen(state, *task));
  }
  return out;
}

Span running_at(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Task& task = *state.running;
  const lang::Frame* frame = task.stack.top;
  while (frame > task.stack.frames && frame->is_host()) --frame;
  return frame->is_host() ? Span{} : span_of(as_it_stands(state, task, *frame));
}

}  // namespace armlet
