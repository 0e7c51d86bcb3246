#pragma once

#include "armlet/model/robot.hpp"

namespace armlet {

// All throw ArgumentError with a sentence that names the joint or link, counted from 1.
void check_joints(const RobotSpec& spec);
void check_links(const RobotSpec& spec);  // one link per joint
void check_home(const RobotSpec& spec);

}  // namespace armlet
