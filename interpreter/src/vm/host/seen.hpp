#pragma once
// How a run that has paused is read: frames, and values as they are shown.

#include <cstdint>
#include <string>

#include "vm/state/state.hpp"

namespace armlet::lang {

// As `print` shows it, cut when it is long.
[[nodiscard]] std::string seen_text(Slot value, const Type& type);

// throws  ArgumentError before the first run.
void require_seen(const VmState& state);

// The frame as it stands: before the statement that begins next, if the task has paused there.
[[nodiscard]] Frame as_it_stands(const VmState& state, const Task& task, const Frame& frame);

// What a frame has come to in the text; empty: nothing yet.
[[nodiscard]] Span span_of(const Frame& frame);

// Whether a variable of the table can be seen where the frame stands; a box has its value by then.
[[nodiscard]] bool find_value(const ScopedVariable& each, const Frame& frame, Span at, Slot& value);

}  // namespace armlet::lang
