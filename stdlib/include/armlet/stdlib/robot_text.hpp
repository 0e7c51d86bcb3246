#pragma once
// Robots as text of the language.

#include <string>
#include <string_view>

#include "armlet/model/robot.hpp"

namespace armlet {

class Host;

// How the last move of a robot of the cell was planned: how long each joint turns or slides and how
// fast, and what decides how fast it could be. Several lines without the last end of line.
[[nodiscard]] std::string last_move_text(const Host& host, int robot);

// The robot as a block of the language: `robot puma560 { joint revolute(...) ... }`. A program that
// holds it makes the same robot: numbers that turn into the same bits, angles in degrees where they
// are exact. A name that is none in the language is changed into one.
[[nodiscard]] std::string robot_block(const Robot& robot);

// The robot as people read it: its name in a line, and its table with one line per joint: kind,
// theta, d, a, alpha and the limits, in degrees to 4 decimals and millimetres to 3.
//
// name  by which it is called, if that is not its own.
[[nodiscard]] std::string robot_table(const Robot& robot, std::string_view name = {});

}  // namespace armlet
