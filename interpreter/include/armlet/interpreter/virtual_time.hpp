// The end of virtual time.
#pragma once

#include <cstdint>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// Virtual time ends a hundred years of 365.25 days after the start of a program.
inline constexpr std::int64_t kEndOfTime_ns = 100LL * 36525 * 86400 * 10'000'000;

// Seconds until virtual time ends for the program: nothing that takes longer can be begun.
[[nodiscard]] double time_left(Vm& vm);

}  // namespace armlet
