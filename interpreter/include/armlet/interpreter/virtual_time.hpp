// Virtual time in seconds, and its end.
#pragma once

#include <cstdint>

namespace armlet {

class Vm;

// The double nearest to this time: 600'000 ns are the same value as `0.6ms` in a program. (A factor
// of 1e-9 would be rounded before it is used, and three times 200 us would not be 0.6 ms.)
[[nodiscard]] constexpr double seconds_of(std::int64_t ns) { return static_cast<double>(ns) / 1e9; }

// Seconds until virtual time ends for the program (RunLimits::time_ns): nothing that takes longer
// can be begun.
[[nodiscard]] double time_left(Vm& vm);

}  // namespace armlet
