#pragma once
// Frames of functions that the host calls.

#include <span>

#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/instructions/unset.hpp"
#include "vm/state/interpret.hpp"

namespace armlet::lang {

// Behind the registers of the frame, and the slots there that native calls may use.
[[nodiscard]] inline Slot* window_above(const Frame& below) {
  return below.base + below.callee->registers + VmState::kScratch;
}

// The host's frame above `below`, which ends the loop when the function above it returns.
inline void push_host(const Task& task, Frame* below, Slot* window) {
  below[1] = {kReturnToHost, window, task.stack.frames->callee, nullptr};
}

// The loop, for a function that the host calls. What is thrown becomes a failure of the program,
// which goes on with whoever handles it.
[[nodiscard, gnu::always_inline]] inline Left enter_function(VmState& state, Task& task,
                                                             Frame* frame, Slot* window,
                                                             const Instr* code) {
  try {
    return interpret(state, task, frame, window, code);
  } catch (...) {
    raise_thrown(state, task);
  }
  return resume_failed(state, task);  // behind the handler, where the result can stay in registers
}

[[nodiscard]] inline bool count_step(VmState& state) {
  return --state.steps.left >= 0 || count_slowly(state);
}

// Runs a function on the task of the host's calls, with the arguments, which stay the caller's.
// False: it failed, and host.error says why.
[[nodiscard]] bool run_for_host(VmState& state, const Callee& callee,
                                std::span<const Slot> arguments, Slot& result);

// What the library is given it may read.
[[nodiscard]] inline bool check_given(VmState& state, const Callee& callee, Slot result) {
  if (check_result(state, callee.program->unset, result, *callee.function->function->result))
    return true;
  state.heap.release(result.o);
  return false;
}

// References of a function that begins are null. They are few, so a call of memset would cost more.
[[gnu::always_inline]] inline void clear_references(const Frame& frame) {
  unsigned count = frame.callee->references;
  for (Slot* reference = frame.base + frame.callee->references_begin; count > 0; --count) {
    reference++->o = nullptr;
    asm volatile("" : "+r"(reference));
  }
}

// The frame of the function above that; the loop is told where it is.
[[gnu::always_inline]] inline void push_function(Frame* below, const Frame& function) {
  below[2] = function;
  clear_references(function);
}

}  // namespace armlet::lang
