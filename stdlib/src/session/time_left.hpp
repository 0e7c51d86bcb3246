#pragma once
// Motions and the end of virtual time.

#include <optional>
#include <string_view>

#include "armlet/interpreter/answer.hpp"

namespace armlet::bind {

// Refuses what is not over before virtual time ends.
Answer<void> check_time_left(Vm& vm, std::string_view what, double seconds, int parameter);

// What a straight move of the tool takes at least, s, whatever the joints can do.
[[nodiscard]] double least_time(double distance, std::optional<double> speed,
                                std::optional<double> accel);

}  // namespace armlet::bind
