// How far the tool point travels along a path of the joints.
#pragma once

#include <span>
#include <vector>

#include "armlet/model/robot.hpp"
#include "trajectory/timing/smooth_run.hpp"

namespace armlet {

// Metres as a function of the parameter of the path, as cubic pieces between its knots whose slope
// is that of the tool at the ends and the middle of each.
std::vector<Segment> tool_travel(const Robot& robot, const Trajectory& path);

// The highest speed of the tool point in zones, as a part of what each allows; looked at finely.
double tool_excess(const Robot& robot, const TimedRun& run, std::span<const SpeedZone> zones);

}  // namespace armlet
