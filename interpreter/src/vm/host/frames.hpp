#pragma once
// Frames of functions that a host calls.

#include <span>

#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/instructions/unset.hpp"
#include "vm/state/interpret.hpp"

namespace armlet::lang {

// The first slot behind the registers of the frame and the slots there for native calls.
[[nodiscard]] inline Slot* window_above(const Frame& below) {
  return below.base + below.callee->registers + VmState::kScratch;
}

// Pushes the host's frame above `below`. It ends the instruction loop when the function above it
// returns.
inline void push_host(const Task& task, Frame* below, Slot* window) {
  below[1] = {kReturnToHost, window, task.stack.frames->callee, nullptr};
}

// Runs the instruction loop for a function that the host calls. An exception becomes a failure of
// the program, and the loop continues in its handler.
[[nodiscard, gnu::always_inline]] inline Left enter_function(VmState& state, Task& task,
                                                             Frame* frame, Slot* window,
                                                             const Instr* code) {
  try {
    return interpret(state, task, frame, window, code);
  } catch (...) {
    raise_thrown(state, task);
  }
  // Outside of the catch block, where the result can stay in registers.
  return resume_failed(state, task);
}

[[nodiscard]] inline bool count_step(VmState& state) {
  return --state.steps.left >= 0 || count_slowly(state);
}

// Runs a function on the task for calls by the host. The caller still owns the arguments. Returns
// false if the function failed; host.error then has the reason.
[[nodiscard]] bool run_for_host(VmState& state, const Callee& callee,
                                std::span<const Slot> arguments, Slot& result);

// Checks that a result for the library has no elements without a value.
[[nodiscard]] inline bool check_given(VmState& state, const Callee& callee, Slot result) {
  if (check_result(state, callee.program->unset, result, *callee.function->function->result))
    return true;
  state.heap.release(result.o);
  return false;
}

// Sets the reference registers of a new frame to null. They are few, so a call of memset would take
// longer.
[[gnu::always_inline]] inline void clear_references(const Frame& frame) {
  unsigned count = frame.callee->references;
  for (Slot* reference = frame.base + frame.callee->references_begin; count > 0; --count) {
    reference++->o = nullptr;
    asm volatile("" : "+r"(reference));
  }
}

// Pushes the frame of the function above the host's frame, and sets the task's top frame.
[[gnu::always_inline]] inline void push_function(Frame* below, const Frame& function) {
  below[2] = function;
  clear_references(function);
}

}  // namespace armlet::lang
