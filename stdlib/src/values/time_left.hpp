#pragma once
// Motions and the end of virtual time.

#include <optional>
#include <string_view>

#include "armlet/interpreter/answer.hpp"

namespace armlet::bind {

// Refuses a duration that would exceed the end of virtual time.
Answer<void> check_time_left(Vm& vm, std::string_view what, double seconds, int parameter);

// A lower bound of the duration of a straight move of the tool, s, for any joint speeds.
[[nodiscard]] double least_time(double distance, std::optional<double> speed,
                                std::optional<double> accel);

}  // namespace armlet::bind
