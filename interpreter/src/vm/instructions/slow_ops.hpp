#pragma once
// Instructions that are not worth a place in the loop, and the rare ways of those that are.
//
// Each takes the registers of the running frame and its instruction, and returns false after
// setting state.fault.

#include <string_view>

#include "vm/state/state.hpp"

namespace armlet::lang {

using SlowOp = bool(VmState& state, Slot* base, const Instr* pc);

SlowOp op_powi, op_powr, op_rtoi, op_cmptext, op_eqdeep;
SlowOp op_box, op_closure, op_newlist, op_makelist, op_newarray, op_makerec, op_listtoreal;
SlowOp op_slice, op_putslice, op_pushref, op_pop, op_insert, op_insertref;
SlowOp op_makemat, op_part, op_putpart, op_rowsof;                       // matrix_ops.cpp
SlowOp op_newmap, op_mapadd, op_mapld, op_mapget, op_maphas, op_maplen;  // map_ops.cpp
SlowOp op_mapkeys, op_mapvalues, op_entryaddr, op_entrymake, op_mappop;
SlowOp op_slicetext, op_charat, op_codeat, op_totext, op_concat;
// -1, 0 or 1, counted as work. False: the failure is set.
bool compare_texts(VmState& state, const TextObj& one, const TextObj& other, int& order);
SlowOp op_wait, op_waituntil;  // leave what is waited for in state.pending
SlowOp op_spawn, op_openwatch, op_watchwhen, op_watchevery;
SlowOp op_parallel, op_endwatch,
    op_stopwatch;  // leave in state.pending what is waited for, if anything
SlowOp op_makeerr, op_throw, op_rethrow, op_catch, op_hold, op_retry, op_assertfail, op_expecterr;

// The direct call gave no number: the whole function is called, which may say why.
bool op_calld_again(VmState& state, Slot* base, const Instr* pc);
// Makes the object in `place` the only owner of its contents, copying it if it is shared. False:
// the failure is set.
[[nodiscard]] bool copy_to_own(VmState& state, Slot& place);
[[nodiscard]] inline bool own(VmState& state, Slot& place) {
  return place.o->refs == 1 || copy_to_own(state, place);
}
// What stands for a row that the instruction does not find in a list of this size.
[[nodiscard]] Obj* missing_row(VmState& state, const Instr* pc, std::int64_t index,
                               std::uint64_t size);
// Adds a long tail to the text in `place`. False: the failure is set.
bool append_slowly(VmState& state, Slot& place, const TextObj& tail);
// Makes sure that the characters of a text have been counted, as work. False: the failure is set.
bool count_characters(VmState& state, TextObj& text);
// The running chunk of steps is used up: looks at the limit and at the wish to cancel.
bool count_slowly(VmState& state);
// A stop request came, which is noticed with the next step rather than here: calls of the library
// are not counted, so that a run that repeats this one could not stop at the same call.
void stop_at_next_step(VmState& state);
// Whether the slice is over, at a place where the run may return to the host: not inside a call of
// the program by the host.
[[nodiscard]] bool may_pause(VmState& state);
// Whether the run pauses before the statement whose MARK is next. Otherwise the statement has
// begun.
[[nodiscard]] bool stops_at_mark(VmState& state);
// Makes room for a frame of `callee` at `frame` with its slots at `window`. False: calls are nested
// too deep or the heap is full, and the failure is set.
bool make_room(VmState& state, Task& task, const Frame* frame, Slot* window, const Callee& callee);
// The ends of a slice, either of them absent or both inside 0 to size, the second not before the
// first. `what` has them: "list", "text".
bool slice_ends(VmState& state, const Slot* ends, std::uint64_t size, std::string_view what,
                std::uint32_t& first, std::uint32_t& last);
// The running task waits for state.pending from now on; `pc` is the instruction that made it wait.
bool begin_wait(VmState& state, Task& task, Slot* result, const Instr* pc);

// An element of this list, which may be a MissingRow.
bool raise_element(VmState& state, const ListObj& list, std::int64_t index);
// The element with this row and column, one of which is outside.
bool raise_cell(VmState& state, const MatrixObj& matrix, std::int64_t row, std::int64_t column);
bool raise_unset(VmState& state, std::uint32_t global);
// Time cannot pass inside a condition or a function that the library calls.
bool raise_may_not_pause(VmState& state);

// The text of an entry has come to its end: what it watches rests until the next one begins. False:
// the main task has to wait for blocks of `when` and `every` that are running.
[[nodiscard]] bool end_entry(VmState& state);

}  // namespace armlet::lang
