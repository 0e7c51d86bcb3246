#pragma once
// Robots as text of the language.

#include <string>

#include "armlet/model/robot.hpp"

namespace armlet {

// The robot as a block of the language: `robot puma560 { joint revolute(...) ... }`. A program that
// holds it makes the same robot: numbers that turn into the same bits, angles in degrees where they
// are exact. A name that is none in the language is changed into one.
[[nodiscard]] std::string robot_block(const Robot& robot);

}  // namespace armlet
