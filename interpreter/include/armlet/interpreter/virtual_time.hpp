// Virtual time in seconds, and its end.
#pragma once

#include <cstdint>

namespace armlet {

class Vm;

// The double nearest to a virtual time: 600'000 ns are the same value as `0.6ms` in a program. (A
// factor 1e-9 would be rounded itself, and three times 200 us would not be 0.6 ms.)
[[nodiscard]] constexpr double seconds_of(std::int64_t ns) { return static_cast<double>(ns) / 1e9; }

// The seconds until the end of virtual time for the program (RunLimits::time_ns). No longer
// operation can begin.
[[nodiscard]] double time_left(Vm& vm);

}  // namespace armlet
