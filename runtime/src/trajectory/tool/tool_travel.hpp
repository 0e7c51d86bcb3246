// Travel of the tool point along a joint path.
#pragma once

#include <span>
#include <vector>

#include "armlet/model/robot.hpp"
#include "trajectory/timing/smooth_run.hpp"

namespace armlet {

// Metres as a function of the parameter of the path, as cubic pieces between its knots with the
// slope of the tool at the ends and in the middle of each.
std::vector<Segment> tool_travel(const Robot& robot, const Trajectory& path);

// The largest ratio of the tool speed to the limit of its zone; sampled finely.
double tool_excess(const Robot& robot, const TimedRun& run, std::span<const SpeedZone> zones);

}  // namespace armlet
