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
// throws  Stopped when a kernel was stopped; the failure is set, and resume_stopped goes on.
[[nodiscard]] Left interpret(VmState& state, Task& task, Frame* frame, Slot* base, const Instr* pc);
// Goes on after a kernel was stopped: with whoever handles the failure.
[[nodiscard]] Left resume_stopped(VmState& state, Task& task);
// The same from task.top on, whatever kernels do.
[[nodiscard]] Left interpret(VmState& state, Task& task);

// What a host frame does when the function above it returns.
extern const Instr kReturnToHost[2];

}  // namespace armlet::lang
