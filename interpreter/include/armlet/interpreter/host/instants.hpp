#pragma once
// Where a run stands, and where it was asked to stop: what a host needs to take a run the same way
// again.

#include <cstdint>
#include <span>
#include <vector>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// Where the run stands. To come there again, run up to the nanosecond before its time and then up
// to its time with the steps that are left.
[[nodiscard]] Instant instant_of(Vm& vm);

// Where a run noticed a wish to stop.
//
// refusals  how often its host had refused to let time pass before (Timeline::advance_to): that may
//           happen at the same instant, and comes first or later.
struct Cancellation {
  Instant at{};
  std::uint32_t refusals = 0;
  bool operator==(const Cancellation&) const = default;
};

// The wishes to stop (Vm::cancel) that the run has noticed, in order.
[[nodiscard]] std::span<const Cancellation> cancellations(Vm& vm);

// Lets the run notice wishes to stop exactly there, where another run of the program has; those
// that were given before are forgotten. Between two slices.
void cancel_at(Vm& vm, std::vector<Cancellation> wishes);

}  // namespace armlet
