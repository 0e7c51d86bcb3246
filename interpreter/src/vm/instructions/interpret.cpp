#include "vm/state/interpret.hpp"

#include <cmath>
#include <cstring>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/instructions/each.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/instructions/unset.hpp"
#include "vm/values/checked.hpp"

// Every instruction ends with a jump of its own to the next one (threaded code), so that branch
// predictors can learn the sequence of instructions. Labels as values are an extension of both of
// our compilers.
#pragma GCC diagnostic ignored "-Wpedantic"

namespace armlet::lang {

const Instr kReturnToHost[2] = {{OpCode::HALT, 0, 0, 0}, {OpCode::HALT, 0, 0, 0}};

namespace {

// The offset of a jump uses the bits of operands b and c.
inline std::int32_t offset_of(const Instr& jump) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(jump.c) << 16U) | jump.b);
}
inline std::int64_t small(std::uint16_t bits) { return static_cast<std::int16_t>(bits); }
inline ListObj& list_in(Slot s) { return *static_cast<ListObj*>(s.o); }
inline TextObj& text_in(Slot s) { return *static_cast<TextObj*>(s.o); }
inline MatrixObj& matrix_in(Slot s) { return *static_cast<MatrixObj*>(s.o); }
inline RecordObj& record_in(Slot s) { return *static_cast<RecordObj*>(s.o); }
inline Slot& place_in(Slot s) { return *reinterpret_cast<Slot*>(s.o); }
inline Slot slot_of_place(Slot* place) { return slot_of(reinterpret_cast<Obj*>(place)); }

[[gnu::always_inline]] inline void set_reference(Heap& heap, Slot& place, Obj* object) {
  Obj* old = place.o;
  place.o = object;
  heap.release(old);
}

// Clears few slots by an ordinary loop. The call of memset that compilers make of such a loop would
// take longer than the rest of a call.
inline void clear(Slot* slots, unsigned count) {
  for (; count != 0; --count, ++slots) {
    slots->o = nullptr;
    asm volatile("" : "+r"(slots));
  }
}

}  // namespace

#ifndef ARMLET_NOTE_EXECUTED  // tests define it to record the instructions that they execute
#define ARMLET_NOTE_EXECUTED(op)
#endif

// The state of the virtual machine in registers of the processor: pc, base and frame. pc is the
// current instruction.
#define RA base[pc->a]
#define RB base[pc->b]
#define RC base[pc->c]
#define CASE(name) L_##name:
#define GO                                       \
  do {                                           \
    ARMLET_NOTE_EXECUTED(pc->op);                \
    goto* labels[static_cast<unsigned>(pc->op)]; \
  } while (false)
#define NEXT \
  do {       \
    ++pc;    \
    GO;      \
  } while (false)
#define NEXT2 \
  do {        \
    pc += 2;  \
    GO;       \
  } while (false)
// Saves pc, so that other code can see the position of the task.
#define SAVE()              \
  do {                      \
    frame->pc = pc + 1;     \
    task.stack.top = frame; \
  } while (false)
// Slow checks of the results of host functions (vm/values/checked.hpp).
#ifdef ARMLET_CHECKED
#define CHECKED_CALL(thunk, args) call_checked(state, *frame, thunk, args)
#else
#define CHECKED_CALL(thunk, args) (thunk)(state.vm, args)
#endif
// A build without the counting of steps shows how much time the counting takes
// (bench/CMakeLists.txt).
#ifdef ARMLET_UNCOUNTED
#define STEP() static_cast<void>(0)
#define STEP_OF_NEXT_WORD() static_cast<void>(0)
#else
#define STEP()                               \
  do {                                       \
    if (--state.steps.left < 0) [[unlikely]] \
      goto no_steps;                         \
  } while (false)
#define STEP_OF_NEXT_WORD()                  \
  do {                                       \
    if (--state.steps.left < 0) [[unlikely]] \
      goto no_steps_of_next_word;            \
  } while (false)
#endif
// States that no later instruction uses the current value of `last`. After calls this lets the
// compiler keep `last` in a register that calls do not preserve. Calls are rare where `last` is
// needed.
#define FORGET() static_cast<void>(last = 0.0)
#define SET_REFERENCE(place, object)    \
  do {                                  \
    set_reference(heap, place, object); \
    FORGET();                           \
  } while (false)
#define FAIL(call) \
  do {             \
    SAVE();        \
    (void)(call);  \
    goto failed;   \
  } while (false)
// Makes the object in the slot unshared before it changes: a copy is made if it has other owners.
#define OWN(slot)                               \
  if ((slot).o->refs != 1) [[unlikely]] {       \
    SAVE();                                     \
    if (!copy_to_own(state, slot)) goto failed; \
  }                                             \
  static_cast<void>(0)
#define OUT_OF_LINE(name, function, words)       \
  CASE(name) {                                   \
    SAVE();                                      \
    if (!function(state, base, pc)) goto failed; \
    FORGET();                                    \
    pc += words;                                 \
    GO;                                          \
  }

Left interpret(VmState& state, Task& task, Frame* frame, Slot* base, const Instr* pc, double last) {
  static const void* const labels[] = {
#define OP(name, ...) &&L_##name,
#define VARIANT(name, ...) &&L_##name,
#include "program/bytecode.def"
#undef VARIANT
#undef OP
  };
  Heap& heap = state.heap;
  // `last` is the accumulator, the double that was computed last. Instructions take it from here
  // and not from its register of the virtual machine, which is in memory: reading it back from
  // there takes longer than the arithmetic.
  GO;

#include "vm/instructions/ops_data.inc"
#include "vm/instructions/ops_flow.inc"
#include "vm/instructions/ops_numbers.inc"
#include "vm/instructions/ops_objects.inc"

failed:
  if (!unwind(state, task)) return {Exit::kFailed};
  frame = task.stack.top;
  base = frame->base;
  pc = frame->pc;
  FORGET();
  GO;

#ifndef ARMLET_UNCOUNTED
// The word after a comparison is a LOOP instruction, which can do the rest of the work alone.
no_steps_of_next_word:
  ++pc;
// Out of steps: the instruction is executed again, with new steps or in the next slice.
no_steps:
  SAVE();
  if (may_pause(state)) {
    frame->pc = pc;
    return {Exit::kSliced, last};
  }
  if (!count_slowly(state)) goto failed;
  ++state.steps.left;
  GO;
#endif
}

// Objects of native functions are released by the exception; the frames were saved before the call.
Left interpret(VmState& state, Task& task, double last) {
  while (true) {
    try {
      return interpret(state, task, task.stack.top, task.stack.top->base, task.stack.top->pc, last);
    } catch (...) {
      raise_thrown(state, task);
    }
    if (!unwind(state, task)) return {Exit::kFailed};
  }
}

Left resume_failed(VmState& state, Task& task) {
  return unwind(state, task) ? interpret(state, task) : Left{Exit::kFailed};
}

}  // namespace armlet::lang
