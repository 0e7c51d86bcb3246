#include "armlet/interpreter/host/instants.hpp"

#include <utility>

#include "vm/state/turn.hpp"

namespace armlet {

// Called after each slice. It only reads, so it need not own the Vm as long as no thread runs the
// program.
Instant instant_of(Vm& vm) {
  const lang::VmState& state = vm.state();
  if (const void* other = state.host.thread.load(std::memory_order_acquire)) [[unlikely]]
    lang::refuse_turn(other);
  return state.instant();
}

std::span<const Cancellation> cancellations(Vm& vm) { return vm.state().cancellations.noticed; }

void cancel_at(Vm& vm, std::vector<Cancellation> wishes) {
  const lang::Turn turn(vm.state());
  vm.state().arm_cancellations(std::move(wishes));
}

}  // namespace armlet
