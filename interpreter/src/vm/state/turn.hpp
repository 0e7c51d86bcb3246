#pragma once
// Exclusive use of a Vm by one thread, and by one call of that thread.

#include "vm/state/state.hpp"

namespace armlet::lang {

// Throws the error that says why the Vm is in use.
[[noreturn]] void refuse_turn(const void* other);

// throws  ArgumentError if the Vm is in use already.
inline void begin_turn(VmState& state) {
  const void* other = nullptr;
  if (!state.host.thread.compare_exchange_strong(other, this_thread(), std::memory_order_acquire))
      [[unlikely]]
    refuse_turn(other);
}
inline void end_turn(VmState& state) {
  state.host.thread.store(nullptr, std::memory_order_release);
}

// In the lifetime of a Turn the program belongs to this thread, which may call its functions.
class Turn {
 public:
  // throws  ArgumentError if the Vm is in use already.
  explicit Turn(VmState& state) : state_(state) { begin_turn(state); }
  [[gnu::always_inline]] ~Turn() { end_turn(state_); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  VmState& state_;
};

}  // namespace armlet::lang
