#pragma once
// Failures: making their messages, finding their handlers, and the error records of programs.
//
// Functions that raise a failure set state.fault and return false, so that they can be the last
// expression of an operation.

#include <string>
#include <string_view>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// ---- where ----------------------------------------------------------------------------------

// The innermost frame that is not a host frame; null if there is none.
[[nodiscard]] const Frame* innermost(const Task& task);
[[nodiscard]] const Frame* innermost(const VmState& state);
// The span and the expression of a frame's running instruction; null if unknown.
[[nodiscard]] const CodeSpan* code_span(const Frame& frame);
// The span and the expression of the innermost frame of the running task that is not a host frame.
[[nodiscard]] const CodeSpan* code_span(const VmState& state);
// The text of a span; empty for an empty one.
[[nodiscard]] std::string source_text(const VmState& state, Span span);
// The line of a span, counted from 1.
[[nodiscard]] inline int line_of(const VmState& state, Span span) {
  return state.programs.newest->sources->position(span).line;
}
// "line 7", or "line 7 of grip.rbt" in a program of several files.
[[nodiscard]] std::string line_name(const VmState& state, Span span);
// The name of a task in messages: "branch 2 of parallel on line 9"; empty for the program.
[[nodiscard]] std::string task_name(const Task& task);
// The current line of a task; 0 if it has not begun.
[[nodiscard]] int task_line(const VmState& state, const Task& task);
// Time, task, calls and loop iteration of the running task.
[[nodiscard]] When circumstances(const VmState& state);

// ---- raising --------------------------------------------------------------------------------

// The rows of messages of the language and of the host.
[[nodiscard]] const MessageTables& messages_of(const VmState& state);
// A failure from the catalogue at the running instruction. The caller completes and raises it.
[[nodiscard]] Diagnostic start_failure(const VmState& state, const Headline& headline);
template <std::size_t N>
[[nodiscard]] Diagnostic start_failure(const VmState& state, CodeFor<N> code,
                                       const std::string (&arguments)[N]) {
  return start_failure(state, Headline(code, arguments));
}
// Raises a failure, whose kind follows from its code, and adds the circumstances.
bool raise(VmState& state, Diagnostic diagnostic);
template <std::size_t N>
bool raise(VmState& state, CodeFor<N> code, const std::string (&arguments)[N]) {
  return raise(state, start_failure(state, code, arguments));
}
inline bool raise(VmState& state, MessageCode<0> code) {
  return raise(state, start_failure(state, Headline(code)));
}
// A failure of a native function, with marks at the positions of its arguments in the text.
[[nodiscard]] Diagnostic diagnostic_of(const VmState& state, const Failure& failure);
bool raise(VmState& state, const Failure& failure);

// Called while an exception of a host function is handled: its text becomes a failure of the
// program (R0626). The exception that ends a thread is thrown again.
void raise_thrown(VmState& state, Task& task);
// A native function returned a failure without setting one: sets a general one.
bool require_failure(VmState& state);

bool raise_out_of_memory(VmState& state);
bool raise_out_of_output(VmState& state);
// Cancels finally blocks that take too long after a stop request.
bool raise_out_of_steps(VmState& state);
bool raise_cancelled(VmState& state);
// what: "list", "text", or "row" or "column" of a matrix.
bool raise_index(VmState& state, std::int64_t index, std::uint64_t size,
                 std::string_view what = "list");
// Raises the failure of a bound of a slice, or a position to insert at, outside of 0 to `most`.
bool raise_end(VmState& state, std::int64_t end, std::uint64_t most, std::uint64_t size,
               std::string_view what = "list");
bool raise_too_deep(VmState& state, const Callee& called, std::uint32_t limit);
bool raise_overflow(VmState& state);
bool raise_division_by_zero(VmState& state);
bool raise_endless_range(VmState& state);
// xs[first:last] with first > last.
bool raise_backwards(VmState& state, std::int64_t first, std::int64_t last);
bool raise_assertion(VmState& state, const AssertInfo& info, const TextObj* note,
                     const TextObj* explanation, const Slot* base);
// `thrown` is null when nothing was thrown.
bool raise_expectation(VmState& state, const hir::AssertThrowsStmt& statement,
                       const RecordObj* thrown, const TextObj* kind);

// ---- handling -------------------------------------------------------------------------------

// Finds the handler of state.fault in the frames above the nearest host frame, and makes its frame
// the top one. Returns false if there is none; the host frame is then removed too.
[[nodiscard]] bool unwind(VmState& state, Task& task);
// Removes the top frame and releases the objects of its registers.
void leave_frame(VmState& state, Task& task);

// Makes the record for `catch (e)` from state.fault, which is then reset. Returns null if the heap
// is full even with its reserve.
[[nodiscard]] RecordObj* catch_error(VmState& state);
// The error record of `error(message, kind:)`.
[[nodiscard]] RecordObj* make_error(VmState& state, TextObj* message, TextObj* kind);
bool throw_error(VmState& state, const RecordObj& error);
// Stores state.fault in an object while a finally block runs, and sets it again afterwards.
[[nodiscard]] Obj* hold_fault(VmState& state);
[[nodiscard]] FaultPtr& held_fault(Obj* held);
bool rethrow(VmState& state, Obj* held);

}  // namespace armlet::lang
