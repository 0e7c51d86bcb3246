// A part of a motion as a motion of its own.
#pragma once

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The motion between two times, beginning at 0.
//
// from, to  s; 0 <= from <= to, and from before the end.
// throws    ArgumentError for other times.
[[nodiscard]] Trajectory part_of(const Trajectory& motion, double from, double to);

}  // namespace armlet
