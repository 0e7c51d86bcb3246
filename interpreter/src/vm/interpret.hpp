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

// Runs task.top until the host frame below it is reached.
[[nodiscard]] Exit interpret(VmState& state, Task& task);

// What a host frame does when the function above it returns.
extern const Instr kReturnToHost[2];

}  // namespace armlet::lang
