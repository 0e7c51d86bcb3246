#pragma once
// The instruction loop.

#include "vm/state.hpp"

namespace armlet::lang {

enum class Exit : std::uint8_t {
  kDone,  // the program ended, or the function called by the host returned (result in register 0 of
          // its frame)
  kFailed,  // nobody in this call of the loop handled state.fault
  kPaused,  // task.waiting is set; task.result says where the result goes
};

// How the loop was left. If a function called by the host returned a double, here it is too: the
// host gets it sooner than from memory.
struct Left {
  Exit exit;
  double result = 0.0;
};

// Runs task.top until the host frame below it is reached.
//
// throws  what functions of the host and kernels throw; the task is as it was when they were
// called.
[[nodiscard]] Left interpret(VmState& state, Task& task, Frame* frame, Slot* base, const Instr* pc);
// The same from task.top on; what is thrown becomes a failure of the program.
[[nodiscard]] Left interpret(VmState& state, Task& task);
// Goes on, in the handler of an exception that came out of the first, with whoever handles it.
[[nodiscard]] Left resume_thrown(VmState& state, Task& task);

// What a host frame does when the function above it returns.
extern const Instr kReturnToHost[2];

}  // namespace armlet::lang
