#pragma once
// What a program may still do once it is being stopped, in steps: only finally blocks run, and soon
// they have to be done. These numbers are steps rather than times, so that a run that is taken
// again stops at the same place.

#include <cstdint>

#include "vm/state/state.hpp"

namespace armlet::lang {

// Of all finally blocks together, however often they pause.
inline constexpr std::uint64_t kLeavingSteps = 1'000'000;
// A failure: its message is made, and finally blocks that fail may call themselves.
inline constexpr std::uint64_t kFailureStepsLeaving = 2000;
// A pause: finally blocks may wait and move some hundred times.
inline constexpr std::uint64_t kPauseStepsLeaving = StepMeter::kChunk;
// A look at a condition: a wait for one ends where time stands in for work.
inline constexpr std::uint64_t kLookStepsLeaving = 50;

}  // namespace armlet::lang
