// The end of virtual time.
#pragma once

#include "armlet/interpreter/native.hpp"

namespace armlet {

// Seconds until virtual time ends for the program (RunLimits::time_ns): nothing that takes longer
// can be begun.
[[nodiscard]] double time_left(Vm& vm);

}  // namespace armlet
