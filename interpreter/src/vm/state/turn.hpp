#pragma once
// One at a time: a Vm belongs to the thread that runs it, and to one call there.

#include "vm/state/state.hpp"

namespace armlet::lang {

// Says why the Vm is busy.
[[noreturn]] void refuse_turn(const void* other);

// throws  ArgumentError if somebody else's turn has not ended.
inline void begin_turn(VmState& state) {
  const void* other = nullptr;
  if (!state.host.thread.compare_exchange_strong(other, this_thread(), std::memory_order_acquire))
      [[unlikely]]
    refuse_turn(other);
}
inline void end_turn(VmState& state) {
  state.host.thread.store(nullptr, std::memory_order_release);
}

// While it lives the program belongs to this thread: its functions can be called.
class Turn {
 public:
  // throws  ArgumentError if somebody else's has not ended.
  explicit Turn(VmState& state) : state_(state) { begin_turn(state); }
  [[gnu::always_inline]] ~Turn() { end_turn(state_); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  VmState& state_;
};

}  // namespace armlet::lang
