// Calls of the program's functions by native functions of the host.

#include <algorithm>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/function_value.hpp"
#include "armlet/interpreter/script_function.hpp"
#include "vm/host/aside.hpp"
#include "vm/host/frames.hpp"
#include "vm/values/checked.hpp"

namespace armlet {

namespace lang {

namespace {

bool has_room(const Task& task, const Frame* below, const Slot* window) {
  return below + 2 < task.stack.frames_end && window < task.stack.slots_end;
}

bool fits(const Task& task, const Frame* below, const Slot* window) {
  return below + 2 < task.stack.frames_limit && window < task.stack.slots_limit;
}

bool refuse(VmState& state, const Callee& callee, bool deep) {
  if (state.host.calls > VmState::kHostCalls) {
    return raise_too_deep(state, callee, VmState::kHostCalls);
  }
  if (!count_step(state)) return false;
  return deep ? raise_too_deep(state, callee, state.options.limits.call_depth)
              : raise_out_of_memory(state);
}

}  // namespace

bool make_room(VmState& state, Task& task, const Frame* frame, Slot* window, const Callee& callee) {
  if (frame >= task.stack.frames_limit || window >= task.stack.slots_limit)
    return raise_too_deep(state, callee, state.options.limits.call_depth);
  return task.stack.grow(state.heap, frame, window, callee.registers) || raise_out_of_memory(state);
}

bool VmState::enter(std::uint32_t function, ClosureObj* closure) {
  Frame* below = running->stack.top;
  Slot* window = window_above(*below);
  const Callee& callee = *programs.callees[function].own;
  if (!has_room(*running, below, window) &&
      !make_room(*this, *running, below + 2, window, callee)) {
    return false;
  }
  push_host(*running, below, window);
  push_function(below, {callee.code, window, &callee, closure});
  running->stack.top = below + 2;
  return true;
}

bool evaluate_with(VmState& state, Task& owner, Obj* function, std::span<const Slot> arguments,
                   Slot& result) {
  const std::uint32_t depth = state.options.limits.call_depth;
  if (state.condition_task == nullptr)
    state.condition_task = std::make_unique<Task>(depth, ample_slots(depth));
  struct Restore {
    Task*& running;
    Task* before;
    ~Restore() { running = before; }
  };
  const Restore restore{state.running, state.running};
  state.running = state.condition_task.get();
  state.running->origin.parent = &owner;
  state.running->host_data = owner.host_data;
  return state.vm.call(function, arguments, result);
}

bool VmState::evaluate(Task& owner, Obj* function, Slot& result) {
  return evaluate_with(*this, owner, function, {}, result);
}

bool VmState::evaluate(Task& owner, Obj* condition, bool& result) {
  Slot value{.i = 0};
  const bool done = evaluate(owner, condition, value);
  result = value.i != 0;
  return done;
}

}  // namespace lang

// A window always has room for arguments (vm/tasks/task.cpp), even when the stack has no room for
// another frame.
namespace {

// The state of the virtual machine, if the program may be called now in this thread.
Vm::State& require_running(Vm::State& state) {
  const void* thread = state.host.thread.load(std::memory_order_relaxed);
  if (thread == lang::this_thread()) [[likely]]
    return state;
  throw ArgumentError(
      thread == nullptr ? "Functions of a program can be called only while it runs."
                        : "Functions of a program can be called only by the thread that runs it.");
}

const ClosureObj* require_function(const Obj* function) {
  if (function == nullptr || function->kind != ObjKind::kClosure)
    throw ArgumentError("What is to be called is no function value of the program.");
  return static_cast<const ClosureObj*>(function);
}

std::string function_name(const lang::Callee& callee) {
  const std::string& name = callee.function->name;
  return name.empty() ? "The function" : '`' + name + '`';
}

const lang::Callee& callee_of(const lang::VmState& state, const Obj* function) {
  return *state.programs.callees[require_function(function)->function].own;
}

void require_count(const lang::Callee& callee, std::size_t arguments) {
  const std::size_t parameters = callee.function->function->parameters.size();
  if (arguments == parameters) return;
  throw ArgumentError(function_name(callee) + " has " + std::to_string(parameters) +
                      " parameters; it was called with " + std::to_string(arguments) +
                      " arguments.");
}

}  // namespace

PreparedCall::PreparedCall(Vm& vm, Obj* function)
    : state_(require_running(vm.state())),
      task_(state_.running),
      below_(state_.running->stack.top),
      window_(lang::window_above(*state_.running->stack.top)),
      callee_(&callee_of(state_, function)),
      function_(static_cast<ClosureObj*>(function)) {
  lang::Task& task = *state_.running;
  lang::Frame* below = task.stack.top;
  const lang::Callee& callee = callee_of(state_, function);
  code_ = callee.code;
  const bool has_room = lang::has_room(task, below, window_) ||
                        (lang::fits(task, below, window_) &&
                         task.stack.grow(state_.heap, below + 2, window_, callee.registers));
  if (++state_.host.calls <= lang::VmState::kHostCalls && has_room) [[likely]] {
    lang::push_host(task, below, window_);  // a call leaves the frame unchanged
  } else {
    below_ = nullptr;  // so that run() is refused
  }
}

PreparedCall::~PreparedCall() { --state_.host.calls; }

PreparedCall::Outcome PreparedCall::run() const {
  lang::VmState& state = state_;
  lang::Task& task = *static_cast<lang::Task*>(task_);
  auto* below = static_cast<lang::Frame*>(below_);
  const auto& callee = *static_cast<const lang::Callee*>(callee_);
  const auto* code = static_cast<const lang::Instr*>(code_);
  if (below == nullptr) [[unlikely]]
    return {lang::refuse(state, callee, !lang::fits(task, task.stack.top, window_))};
  if (!lang::count_step(state)) [[unlikely]]
    return {false};
  lang::push_function(below, {code, window_, &callee, function_});
  const lang::Left left = lang::enter_function(state, task, below + 2, window_, code);
  if (left.exit != lang::Exit::kDone) [[unlikely]]
    return {false};
  task.stack.top = below;
  if (callee.checks_result && !lang::check_given(state, callee, *window_)) [[unlikely]]
    return {false};
  return {true, left.result};
}

void require_types(Vm& vm, const Obj* function, std::span<const Kind> parameters, Kind result) {
  const lang::Callee& callee = callee_of(vm.state(), function);
  const lang::hir::Function& declared = *callee.function->function;
  const auto is = [](const Type* type, Kind kind) {
    return type->is(kind) || (kind == Kind::kInt && type->is(Kind::kEnum));
  };
  require_count(callee, parameters.size());
  bool fits = is(declared.result, result);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    fits = fits && is(declared.parameters[i]->type, parameters[i]);
  if (fits) return;
  throw ArgumentError(function_name(callee) +
                      " has other types than the ScriptFunction that calls it.");
}

const Type* parameter_type(Vm& vm, const Obj* function, std::size_t index) {
  const auto& parameters = callee_of(vm.state(), function).function->function->parameters;
  return index < parameters.size() ? parameters[index]->type : nullptr;
}

bool Vm::call(Obj* function, std::span<const Slot> arguments, Slot& result) {
  const PreparedCall call(*this, function);
  const lang::Callee& callee = callee_of(*state_, function);
  require_count(callee, arguments.size());
#ifdef ARMLET_CHECKED
  lang::require_values(*callee.function->function, arguments);
#endif
  std::ranges::copy(arguments, call.window());
  if (!call.run().done) return false;
  result = *call.window();
  return true;
}

}  // namespace armlet
