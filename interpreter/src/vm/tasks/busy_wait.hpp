#pragma once
// Loops that wait for no time: the clock stands still for as long as they run.

#include "vm/state/state.hpp"

namespace armlet::lang {

// A wait for a time or a motion, without a condition, begins.
void count_wait(Task& task, std::int64_t now_ns);

// The task that has begun at least `waits` waits at this instant; null: there is none.
[[nodiscard]] Task* find_busy_task(VmState& state, int waits);

// R0647 in that task after so many rounds, with the wait, and with the condition of the loop around
// it as what to wait for.
void raise_busy_wait(VmState& state, Task& task, int rounds);

}  // namespace armlet::lang
