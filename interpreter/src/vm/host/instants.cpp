#include "armlet/interpreter/host/instants.hpp"

#include <utility>

#include "vm/turn.hpp"

namespace armlet {

Instant instant_of(Vm& vm) {
  const lang::Turn turn(vm.state());
  return vm.state().instant();
}

std::span<const Cancellation> cancellations(Vm& vm) { return vm.state().cancellations.noticed; }

void cancel_at(Vm& vm, std::vector<Cancellation> wishes) {
  const lang::Turn turn(vm.state());
  vm.state().arm_cancellations(std::move(wishes));
}

}  // namespace armlet
