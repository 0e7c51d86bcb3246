#pragma once
// Robots as text of the language.

#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"

namespace armlet {

class Host;

// How the last move of a robot of the cell was planned: duration and speed of each joint, and the
// limit that decides the duration. Several lines without the last end of line.
[[nodiscard]] std::string last_move_text(const Host& host, int robot);

// The robot as a block of the language: `robot puma560 { joint revolute(...) ... }`. A program with
// this block makes the same robot: numbers are read back as the same bits, angles are in degrees if
// that is exact. A name that the language does not allow is changed into an allowed one.
[[nodiscard]] std::string robot_block(const Robot& robot);

// The robot as a text for users: its name in a line, and a table with one line per joint: kind,
// theta, d, a, alpha and the limits, in degrees to 4 decimals and millimetres to 3.
//
// name  name to print, if not the robot's own.
[[nodiscard]] std::string robot_table(const Robot& robot, std::string_view name = {});

}  // namespace armlet
