#pragma once
// The limits, in steps, for a program that is being stopped: only its finally blocks run, and they
// have to end soon. The limits are steps and not times, so that a replay stops at the same
// statement.

#include <cstdint>

#include "vm/state/state.hpp"

namespace armlet::lang {

// For all finally blocks together, including their pauses.
inline constexpr std::uint64_t kLeavingSteps = 1'000'000;
// The steps that a failure counts: its message takes time, and finally blocks that fail may call
// themselves.
inline constexpr std::uint64_t kFailureStepsLeaving = 2000;
// The steps that a pause counts: finally blocks may wait and move some hundred times.
inline constexpr std::uint64_t kPauseStepsLeaving = StepMeter::kChunk;
// The steps that the evaluation of a condition counts, so that a wait for a condition ends too.
inline constexpr std::uint64_t kLookStepsLeaving = 50;

}  // namespace armlet::lang
