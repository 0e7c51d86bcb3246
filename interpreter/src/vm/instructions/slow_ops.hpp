#pragma once
// Instructions outside of the instruction loop because they are long, and the rare cases of
// instructions in the loop.
//
// Each function takes the registers of the running frame and its instruction. It returns false
// after setting state.fault.

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
// Compares texts and counts the work: -1, 0 or 1. Returns false, with the failure set, if a stop is
// due.
bool compare_texts(VmState& state, const TextObj& one, const TextObj& other, int& order);
SlowOp op_wait, op_waituntil;  // set state.pending to the wait
SlowOp op_spawn, op_openwatch, op_watchwhen, op_watchevery;
SlowOp op_parallel, op_endwatch,
    op_stopwatch;  // set state.pending to the wait if there is one
SlowOp op_makeerr, op_throw, op_rethrow, op_catch, op_hold, op_retry, op_assertfail, op_expecterr;

// The direct form of a call returned no number, so the ordinary function is called, which may give
// the reason.
bool op_calld_again(VmState& state, Slot* base, const Instr* pc);
// Makes the object in `place` the only owner of its contents, by a copy if it is shared. Returns
// false, with the failure set, if that fails.
[[nodiscard]] bool copy_to_own(VmState& state, Slot& place);
[[nodiscard]] inline bool own(VmState& state, Slot& place) {
  return place.o->refs == 1 || copy_to_own(state, place);
}
// The substitute for a row that the instruction does not find in a list of this size.
[[nodiscard]] Obj* missing_row(VmState& state, const Instr* pc, std::int64_t index,
                               std::uint64_t size);
// Appends a long tail to the text in `place`. Returns false, with the failure set, if that fails.
bool append_slowly(VmState& state, Slot& place, const TextObj& tail);
// Counts the characters of a text, which is work, if they are not counted yet. Returns false, with
// the failure set, if a stop is due.
bool count_characters(VmState& state, TextObj& text);
// The running chunk of steps is used up: checks the limit of steps and stop requests.
bool count_slowly(VmState& state);
// A stop request arrived during a call. It takes effect at the next step: calls of library
// functions are not counted, so a replay could not find the same call again.
void stop_at_next_step(VmState& state);
// Whether the slice is over at a point where the run can return to the host, which is not so inside
// a call by the host.
[[nodiscard]] bool may_pause(VmState& state);
// Whether the run pauses before the statement whose MARK is next. If not, the statement counts as
// begun.
[[nodiscard]] bool stops_at_mark(VmState& state);
// Grows the stack for a frame of `callee` at `frame` with its slots at `window`. Returns false,
// with the failure set, if calls are nested too deep or the heap is full.
bool make_room(VmState& state, Task& task, const Frame* frame, Slot* window, const Callee& callee);
// The bounds of a slice of a text or list with `size` elements. Both are optional; they must be in
// order and inside 0 to size. `what` names the object in messages: "list", "text".
bool slice_ends(VmState& state, const Slot* ends, std::uint64_t size, std::string_view what,
                std::uint32_t& first, std::uint32_t& last);
// Lets the running task wait for state.pending; `pc` is the instruction that waits.
bool begin_wait(VmState& state, Task& task, Slot* result, const Instr* pc);

// Raises the failure for an index outside of this list, which may be a MissingRow.
bool raise_element(VmState& state, const ListObj& list, std::int64_t index);
// Raises the failure for a row or a column outside of the matrix.
bool raise_cell(VmState& state, const MatrixObj& matrix, std::int64_t row, std::int64_t column);
bool raise_unset(VmState& state, std::uint32_t global);
// Raises the failure of a wait inside a condition or a function that the library calls.
bool raise_may_not_pause(VmState& state);

// Ends the text of an entry: its watches are disarmed until the next entry begins. Returns false if
// the main task has to wait for running bodies of `when` and `every`.
[[nodiscard]] bool end_entry(VmState& state);

}  // namespace armlet::lang
