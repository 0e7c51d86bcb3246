#include "vm/turn.hpp"

#include "armlet/core/error.hpp"

namespace armlet::lang {

Turn::Turn(VmState& state) : state_(state) {
  const void* other = nullptr;
  const void* mine = this_thread();
  if (state.thread.compare_exchange_strong(other, mine, std::memory_order_acquire)) return;
  throw ArgumentError(other == mine
                          ? "This Vm runs already: a function that it calls cannot run it."
                          : "This Vm runs already, in another thread.");
}

}  // namespace armlet::lang
