#pragma once

#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Times at which a motion is sampled for drawing, ascending from 0 to its duration: `even` of them
// evenly spaced, and every knot with the instant before it, so that corners and jumps are drawn
// exactly. If there are more than 2000 knots, 4000 evenly spaced times without the knots.
//
// even     at least 2.
// returns  times, s.
std::vector<double> drawing_times(const Trajectory& motion, int even = 201);

}  // namespace armlet
