#pragma once
// Detects loops in which no time passes, so that the clock stands still while they run.

#include "vm/state/state.hpp"

namespace armlet::lang {

// Counts a wait for a time or a motion, without a condition, that begins now.
void count_wait(Task& task, std::int64_t now_ns);

// The task that has begun at least `waits` waits at this instant; null if there is none.
[[nodiscard]] Task* find_busy_task(VmState& state, int waits);

// Raises R0647 in the task after `rounds` rounds. The message shows the wait and proposes to wait
// for the condition of the loop around it.
void raise_busy_wait(VmState& state, Task& task, int rounds);

}  // namespace armlet::lang
