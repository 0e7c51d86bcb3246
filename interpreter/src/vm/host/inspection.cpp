#include "armlet/interpreter/host/inspection.hpp"

#include <string>

#include "armlet/core/error.hpp"
#include "format_value.hpp"
#include "vm/failures/failures.hpp"
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

SeenTask seen(const lang::Task& task) {
  SeenTask out;
  out.name = lang::task_name(task);
  if (task.waiting != nullptr && !task.waits_for_its_tasks()) out.waits = task.waiting->what();
  for (const lang::Frame* frame = task.top; frame > task.frames; --frame) {
    if (frame->is_host()) continue;
    const lang::CodeSpan* at = lang::code_span(*frame);
    const lang::hir::Function* function = frame->callee->function->function;
    const bool is_block = function != nullptr && function->is_task;
    out.calls.push_back({is_block ? std::string() : frame->callee->function->name,
                         at == nullptr ? Span{} : at->span});
  }
  return out;
}

}  // namespace

std::vector<SeenVariable> seen_variables(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  require_begun(state);
  std::vector<SeenVariable> out;
  for (const lang::hir::Variable* variable : state.program.module.globals) {
    if (!variable->is_open) continue;
    const bool is_set = state.global_is_set[variable->index] != 0;
    out.push_back({std::string(variable->name), type_name(variable->type),
                   is_set ? shown(state.globals[variable->index], *variable->type) : std::string(),
                   variable->declared});
  }
  return out;
}

std::vector<SeenTask> seen_tasks(Vm& vm) {
  const lang::VmState& state = vm.state();
  const lang::Turn turn(vm.state());
  require_begun(state);
  std::vector<SeenTask> out;
  if (vm.result().status != Progress::kPaused) return out;
  out.push_back(seen(state.main));
  for (const auto& task : state.tree.all()) {
    if (!task->has_ended) out.push_back(seen(*task));
  }
  return out;
}

Span running_at(Vm& vm) {
  const lang::CodeSpan* at = lang::code_span(vm.state());
  return at == nullptr ? Span{} : at->span;
}

}  // namespace armlet
