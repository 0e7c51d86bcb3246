#pragma once

#include <span>

namespace armlet {

// Throws ArgumentError unless there are at least two points and their times ascend from 0.
void check_points(std::span<const double> t, std::span<const double> q);

}  // namespace armlet
