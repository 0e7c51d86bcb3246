#pragma once
// The instants of a run: its current one, and those of stop requests. A host needs them to replay
// the run.

#include <cstdint>
#include <span>
#include <vector>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// The current instant of the run. To reach it again, run up to the nanosecond before its time, and
// then up to its time with the remaining steps.
[[nodiscard]] Instant instant_of(Vm& vm);

// The instant at which a stop request took effect in a run.
//
// refusals  how often the host had refused before to let time pass (Timeline::advance_to). A
//           refusal may happen at the same instant, before or after the request.
struct Cancellation {
  Instant at{};
  std::uint32_t refusals = 0;
  bool operator==(const Cancellation&) const = default;
};

// The stop requests (Vm::cancel) that have taken effect in the run, in order.
[[nodiscard]] std::span<const Cancellation> cancellations(Vm& vm);

// Lets stop requests take effect at the instants of another run of the program; they replace those
// of earlier calls. Called between two slices.
void cancel_at(Vm& vm, std::vector<Cancellation> wishes);

}  // namespace armlet
