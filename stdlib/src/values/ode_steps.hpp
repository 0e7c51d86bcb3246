// The steps of an integration over time.
#pragma once

#include <span>
#include <vector>

namespace armlet::bind {

// Steps for an integration: between two knots all steps are equal, and none is longer than `step`.
//
// knots    s, at least one, strictly ascending; the first is the start and the last is the end.
// step     s, > 0.
// returns  the number of steps; beyond 2^53 not a whole number.
double count_steps(std::span<const double> knots, double step);

// The start and the end of every step; the knots are among them exactly.
std::vector<double> step_times(std::span<const double> knots, double step);

}  // namespace armlet::bind
