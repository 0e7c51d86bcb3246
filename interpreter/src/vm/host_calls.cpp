// Calls of the program by the host.

#include <algorithm>

#include "vm/failures.hpp"
#include "vm/interpret.hpp"
#include "vm/slow_ops.hpp"

namespace armlet {

namespace lang {

namespace {

// Behind the registers of the frame, and the slots there that native calls may use.
Slot* window_above(const Frame& below) {
  return below.base + below.callee->registers + VmState::kScratch;
}

// Puts a host frame and the function's frame above `below`. False: calls are nested too deep.
inline bool push_frames(VmState& state, Frame* below, Slot* base, const Callee& callee,
                        ClosureObj* closure) {
  Task& task = *state.running;
  if (below + 2 >= task.frames_end || base >= task.slots_end) [[unlikely]] {
    return raise_too_deep(state, callee, state.options.limits.call_depth);
  }
  below[1] = {kReturnToHost, base, task.frames->callee, nullptr};
  below[2] = {callee.code, base, &callee, closure};
  task.top = below + 2;
  for (unsigned i = 0; i < callee.references; ++i) base[callee.references_begin + i].o = nullptr;
  return true;
}

}  // namespace

bool VmState::enter(std::uint32_t function, ClosureObj* closure) {
  Frame* below = running->top;
  return push_frames(*this, below, window_above(*below), callees[function], closure);
}

bool VmState::evaluate(Task& owner, Obj* function, Slot& result) {
  const std::uint32_t depth = options.limits.call_depth;
  if (condition_task == nullptr) condition_task = std::make_unique<Task>(depth, ample_slots(depth));
  Task* before = running;
  running = condition_task.get();
  running->parent = &owner;
  running->host_data = owner.host_data;
  const bool done = vm.call(function, {}, result);
  running = before;
  return done;
}

bool VmState::evaluate(Task& owner, Obj* condition, bool& result) {
  Slot value{.i = 0};
  const bool done = evaluate(owner, condition, value);
  result = value.i != 0;
  return done;
}

}  // namespace lang

// A window always has room for arguments (vm/task.cpp); whether the frames fit is asked later.
PreparedCall::PreparedCall(Vm& vm, Obj* function)
    : state_(vm.state()),
      below_(state_.running->top),
      function_(function),
      callee_(&state_.callees[static_cast<ClosureObj*>(function)->function]),
      window_(lang::window_above(*below_)) {}

bool PreparedCall::run() const {
  lang::VmState& state = state_;
  if (state.host_calls >= lang::VmState::kHostCalls) [[unlikely]] {
    return lang::raise_too_deep(state, *callee_, lang::VmState::kHostCalls);
  }
  if (--state.steps.left < 0 && !lang::count_slowly(state)) [[unlikely]] {
    return false;
  }
  auto* closure = static_cast<ClosureObj*>(function_);
  if (!lang::push_frames(state, below_, window_, *callee_, closure)) return false;
  ++state.host_calls;
  const lang::Exit exit = lang::interpret(state, *state.running);
  --state.host_calls;
  if (exit != lang::Exit::kDone) return false;
  state.running->top = below_;  // without the host's frame, whose register 0 is the window
  return true;
}

bool Vm::call(Obj* function, std::span<const Slot> arguments, Slot& result) {
  const PreparedCall call(*this, function);
  std::ranges::copy(arguments, call.window());
  if (!call.run()) return false;
  result = *call.window();
  return true;
}

}  // namespace armlet
