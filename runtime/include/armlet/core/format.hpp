#pragma once

#include <string>

namespace armlet {

// Readable numbers: at most `digits` decimals, no trailing zeros, never "-0".
std::string format_number(double value, int digits = 3);

// "37.2 mm" from metres and "12.3 deg" from radians, with one decimal at most.
std::string format_mm(double length);
std::string format_deg(double angle);

}  // namespace armlet
