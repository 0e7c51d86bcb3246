#pragma once
// One at a time: a Vm belongs to the thread that runs it, and to one call there.

#include "vm/state.hpp"

namespace armlet::lang {

// A turn of a thread that is not the owner, or not yet.
//
// throws  ArgumentError as begin_turn.
void take_turn(Turns& turns);

// The owner's turns take no instruction that all threads have to see at once: others see to that
// when they come (turn.cpp).
//
// throws  ArgumentError if somebody else's turn has not ended.
[[gnu::always_inline]] inline void begin_turn(VmState& state) {
  Turns& turns = state.host.turns;
  const void* const me = this_thread();
  if (turns.owner.load(std::memory_order_relaxed) == me &&
      !turns.owner_is_in.load(std::memory_order_relaxed)) [[likely]] {
    turns.owner_is_in.store(true, std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
    if (turns.owner.load(std::memory_order_relaxed) == me) [[likely]] {
      turns.runs.store(me, std::memory_order_relaxed);
      return;
    }
    turns.owner_is_in.store(false, std::memory_order_release);
  }
  take_turn(turns);
}
[[gnu::always_inline]] inline void end_turn(VmState& state) {
  Turns& turns = state.host.turns;
  turns.runs.store(nullptr, std::memory_order_relaxed);
  if (!turns.is_plain) [[likely]] {
    turns.owner_is_in.store(false, std::memory_order_release);
  } else {
    turns.is_plain = false;
    turns.plain.store(nullptr, std::memory_order_release);
  }
}

// While it lives the program belongs to this thread: its functions can be called.
class Turn {
 public:
  // throws  ArgumentError if somebody else's has not ended.
  explicit Turn(VmState& state) : state_(state) { begin_turn(state); }
  ~Turn() { end_turn(state_); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  VmState& state_;
};

}  // namespace armlet::lang
