// The steps of an integration over time.
#pragma once

#include <span>
#include <vector>

namespace armlet::bind {

// From knot to knot all steps are equal, and none is longer than `step`.
//
// knots    s, at least one; no two alike, the first is the start and the last is the end.
// step     s, > 0.
// returns  how many steps that makes; not a whole number beyond 2^53.
double count_steps(std::span<const double> knots, double step);

// The start and the end of every step, the knots among them exactly.
std::vector<double> step_times(std::span<const double> knots, double step);

}  // namespace armlet::bind
