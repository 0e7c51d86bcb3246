#pragma once
// Tables of robots and hands.

#include <string>

#include "armlet/model/hands.hpp"
#include "armlet/model/robot.hpp"

namespace armlet::cli {

// One letter per joint: R revolute, P prismatic.
std::string kinds_of(const Robot& robot);

// Rows, limits, reach and kinematics, in degrees and millimetres.
std::string robot_text(const Robot& robot);

// The table of a robot as one line of JSON, in SI units.
std::string robot_json(const Robot& robot);

// The actuators of a hand with fingers, and the joints that they move.
std::string hand_text(const Hand& hand);

}  // namespace armlet::cli
