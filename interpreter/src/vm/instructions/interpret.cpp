#include "vm/state/interpret.hpp"

#include <cmath>
#include <cstring>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/instructions/each.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/instructions/unset.hpp"
#include "vm/values/checked.hpp"

// Every instruction ends with its own jump to the next one: branch predictors learn the program
// that way. Labels as values are an extension that both of our compilers have.
#pragma GCC diagnostic ignored "-Wpedantic"

namespace armlet::lang {

const Instr kReturnToHost[2] = {{OpCode::HALT, 0, 0, 0}, {OpCode::HALT, 0, 0, 0}};

namespace {

// The offset of a jump lies across b and c.
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

// Few slots: the memset that compilers make of such a loop would cost more than the rest of a call.
inline void clear(Slot* slots, unsigned count) {
  for (; count != 0; --count, ++slots) {
    slots->o = nullptr;
    asm volatile("" : "+r"(slots));
  }
}

}  // namespace

#ifndef ARMLET_NOTE_EXECUTED  // tests count which instructions they reach
#define ARMLET_NOTE_EXECUTED(op)
#endif

// Registers of the machine that live in registers of the processor: pc, base and frame. pc is the
// running instruction.
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
// Others may look at the task from here on.
#define SAVE()              \
  do {                      \
    frame->pc = pc + 1;     \
    task.stack.top = frame; \
  } while (false)
// Costly checks of what functions of the host leave (vm/values/checked.hpp).
#ifdef ARMLET_CHECKED
#define CHECKED_CALL(thunk, args) call_checked(state, *frame, thunk, args)
#else
#define CHECKED_CALL(thunk, args) (thunk)(state.vm, args)
#endif
// A build that counts no steps shows what counting costs (bench/CMakeLists.txt).
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
// Nothing takes `last` from before here. Saying so behind calls keeps it in a register of the
// processor, which calls do not preserve; where it is needed they are rare.
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
// The object in the slot will be changed: it is copied first if others see it too.
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
  // `last` is the double computed last. Instructions that need it take it from here rather than
  // from its register, which lies in memory: getting it back from there takes longer than the
  // arithmetic.
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
// Behind a comparison comes a LOOP, which does the rest alone.
no_steps_of_next_word:
  ++pc;
// The instruction is executed again, with steps to count or in the next slice.
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

// What native functions own goes with the exception, and the frames were saved before the call.
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
