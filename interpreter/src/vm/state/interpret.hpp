#pragma once
// The instruction loop of the virtual machine.

#include "vm/state/state.hpp"

namespace armlet::lang {

enum class Exit : std::uint8_t {
  kDone,  // the program ended, or the function called by the host returned (result in register 0 of
          // its frame)
  kFailed,  // nobody in this call of the loop handled state.fault
  kPaused,  // task.waiting is set; task.result is where the result goes
  kSliced,  // the slice is over; the loop can continue from task.stack.top with Left::result
};

// The result of the loop. If a function called by the host returned a double, it is here as well,
// because this is faster for the host than reading it from memory. After kSliced it is the
// accumulator, which following instructions may use.
struct Left {
  Exit exit;
  double result = 0.0;
};

// Runs the frame task.stack.top until the host frame below it is reached.
//
// last    the accumulator, if the loop continues after kSliced.
// throws  the exceptions of host functions and kernels; the task is then in its state before the
//         call.
[[nodiscard]] Left interpret(VmState& state, Task& task, Frame* frame, Slot* base, const Instr* pc,
                             double last = 0.0);
// Runs the task from task.stack.top on. An exception becomes a failure of the program.
[[nodiscard]] Left interpret(VmState& state, Task& task, double last = 0.0);
// Continues in the handler of the failure state.fault.
[[nodiscard, gnu::cold]] Left resume_failed(VmState& state, Task& task);

// The instructions of a host frame, which run when the function above it returns.
extern const Instr kReturnToHost[2];

}  // namespace armlet::lang
