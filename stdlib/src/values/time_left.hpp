#pragma once
// Motions and the end of virtual time.

#include <string_view>

#include "armlet/interpreter/answer.hpp"

namespace armlet::bind {

// Refuses a duration that would exceed the end of virtual time.
Answer<void> check_time_left(Vm& vm, std::string_view what, double seconds, CallPart part);

}  // namespace armlet::bind
