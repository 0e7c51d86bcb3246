#pragma once
// Failures: making their messages, finding who handles them, and the error records that programs
// see.
//
// Functions that raise set state.fault and return false, so that they can be the last word of an
// operation.

#include <string>
#include <string_view>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// ---- where ----------------------------------------------------------------------------------

// The innermost frame that is not the host's; null if there is none.
[[nodiscard]] const Frame* innermost(const Task& task);
[[nodiscard]] const Frame* innermost(const VmState& state);
// What the running instruction of a frame belongs to in the text; null if unknown.
[[nodiscard]] const CodeSpan* code_span(const Frame& frame);
// The same of the innermost frame of the running task that is not the host's.
[[nodiscard]] const CodeSpan* code_span(const VmState& state);
// The text of a span; empty for an empty one.
[[nodiscard]] std::string source_text(const VmState& state, Span span);
// Line of a span, from 1.
[[nodiscard]] inline int line_of(const VmState& state, Span span) {
  return state.programs.newest->sources->position(span).line;
}
// "line 7", or "line 7 of grip.rbt" in a program of several files.
[[nodiscard]] std::string line_name(const VmState& state, Span span);
// What a task is called in messages: "branch 2 of parallel on line 9"; empty for the program.
[[nodiscard]] std::string task_name(const Task& task);
// The line at which a task is; 0 if it has not begun.
[[nodiscard]] int task_line(const VmState& state, const Task& task);
// Time, task, call path and loop pass of the running task.
[[nodiscard]] When circumstances(const VmState& state);

// ---- raising --------------------------------------------------------------------------------

// The rows of the language and of the host.
[[nodiscard]] const MessageTables& messages_of(const VmState& state);
// A failure from the catalogue at the running instruction, to be completed and raised.
[[nodiscard]] Diagnostic start_failure(const VmState& state, const Headline& headline);
template <std::size_t N>
[[nodiscard]] Diagnostic start_failure(const VmState& state, CodeFor<N> code,
                                       const std::string (&arguments)[N]) {
  return start_failure(state, Headline(code, arguments));
}
// The kind comes from the code. Adds the circumstances.
bool raise(VmState& state, Diagnostic diagnostic);
template <std::size_t N>
bool raise(VmState& state, CodeFor<N> code, const std::string (&arguments)[N]) {
  return raise(state, start_failure(state, code, arguments));
}
inline bool raise(VmState& state, MessageCode<0> code) {
  return raise(state, start_failure(state, Headline(code)));
}
// A failure of a native function, with its marks put where the arguments were written.
[[nodiscard]] Diagnostic diagnostic_of(const VmState& state, const Failure& failure);
bool raise(VmState& state, const Failure& failure);

// In the handler of an exception that a function of the host has thrown while the task ran: its
// words become a failure of the program (R0626). The end of a thread goes on as it was.
void raise_thrown(VmState& state, Task& task);
// A native function has failed: it should have said why.
bool require_failure(VmState& state);

bool raise_out_of_memory(VmState& state);
bool raise_out_of_output(VmState& state);
// Finally blocks that go on for too long after a stop request are cancelled like what they end.
bool raise_out_of_steps(VmState& state);
bool raise_cancelled(VmState& state);
// what: "list", "text", or "row" or "column" of a matrix.
bool raise_index(VmState& state, std::int64_t index, std::uint64_t size,
                 std::string_view what = "list");
// The end of a slice, or a place to insert: outside 0 to `most`.
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

// Finds who handles state.fault in the frames above the nearest host frame, and makes it the top of
// the task. False: nobody; the host frame is removed too.
[[nodiscard]] bool unwind(VmState& state, Task& task);
// Removes the frame on top and releases what its registers own.
void leave_frame(VmState& state, Task& task);

// The record that `catch (e)` gets; takes state.fault. Null: the heap is full even with its
// reserve.
[[nodiscard]] RecordObj* catch_error(VmState& state);
// An error record as `error(message, kind:)` makes it.
[[nodiscard]] RecordObj* make_error(VmState& state, TextObj* message, TextObj* kind);
bool throw_error(VmState& state, const RecordObj& error);
// Keeps state.fault in an object for the time of a finally block, and brings it back.
[[nodiscard]] Obj* hold_fault(VmState& state);
[[nodiscard]] FaultPtr& held_fault(Obj* held);
bool rethrow(VmState& state, Obj* held);

}  // namespace armlet::lang
