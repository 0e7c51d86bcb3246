#pragma once
// Reads a run that is paused: frames, and values as text.

#include <cstdint>
#include <string>

#include "vm/state/state.hpp"

namespace armlet::lang {

// The text of a value as `print` shows it, shortened if it is long.
[[nodiscard]] std::string seen_text(Slot value, const Type& type);

// throws  ArgumentError before the first run.
void require_seen(const VmState& state);

// A copy of the frame at its current position: before the next statement, if the task is paused
// there.
[[nodiscard]] Frame as_it_stands(const VmState& state, const Task& task, const Frame& frame);

// The span of the statement that the frame executes; empty before the first one.
[[nodiscard]] Span span_of(const Frame& frame);

// Finds the value of a variable of the table, if the variable is visible at the frame's position.
// The value of a boxed variable is read from its box.
[[nodiscard]] bool find_value(const ScopedVariable& each, const Frame& frame, Span at, Slot& value);

}  // namespace armlet::lang
