#pragma once
// The instruction loop.

#include "vm/state/state.hpp"

namespace armlet::lang {

enum class Exit : std::uint8_t {
  kDone,  // the program ended, or the function called by the host returned (result in register 0 of
          // its frame)
  kFailed,  // nobody in this call of the loop handled state.fault
  kPaused,  // task.waiting is set; task.result says where the result goes
  kSliced,  // the slice is over; the loop can go on from task.stack.top with Left::result
};

// How the loop was left. If a function called by the host returned a double, here it is too: the
// host gets it sooner than from memory. After kSliced it is the double computed last, which the
// instructions to come may take from the processor.
struct Left {
  Exit exit;
  double result = 0.0;
};

// Runs task.stack.top until the host frame below it is reached.
//
// last    the double computed last, when the loop goes on after kSliced.
// throws  what functions of the host and kernels throw; the task is as it was when they were
//         called.
[[nodiscard]] Left interpret(VmState& state, Task& task, Frame* frame, Slot* base, const Instr* pc,
                             double last = 0.0);
// The same from task.stack.top on; what is thrown becomes a failure of the program.
[[nodiscard]] Left interpret(VmState& state, Task& task, double last = 0.0);
// Goes on with whoever handles the failure that is set.
[[nodiscard, gnu::cold]] Left resume_failed(VmState& state, Task& task);

// What a host frame does when the function above it returns.
extern const Instr kReturnToHost[2];

}  // namespace armlet::lang
