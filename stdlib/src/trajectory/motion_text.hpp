#pragma once
// A motion as text: durations, the joint that limits it, peaks.

#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet::bind {

// Several lines without the last end of line. `what`: "moveJ of scara". Without parts in the notes,
// a motion of a few segments is reported segment by segment.
[[nodiscard]] std::string explain_motion(std::string_view what, const Robot& robot,
                                         const Trajectory& motion, const MotionNotes& notes = {},
                                         Trajectory::Start start = Trajectory::Start::kAtRest);

}  // namespace armlet::bind
