#pragma once

#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Times at which a motion is looked at to be drawn, ascending from 0 to its duration: `even` of
// them evenly, and every knot with the instant before it, so that corners and jumps are drawn where
// they are. Of more than 2000 knots none is looked at beside the even times, of which there are
// then 4000.
//
// even     at least 2.
// returns  times, s.
std::vector<double> drawing_times(const Trajectory& motion, int even = 201);

}  // namespace armlet
