#pragma once
// Positions in formatted texts: f"{p:.2f mm}".

#include <string_view>

#include "armlet/interpreter/answer.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// As `print` shows it, with each number in the style, which is a format of fmt ("+8.2f"). A unit of
// lengths is that of the place, one of angles that of the orientation; the others are in mm and
// deg.
[[nodiscard]] std::string format_posc(const PosC& p, std::string_view style, std::string_view unit);
// The same of joints that turn and of those that slide. What the joints do may not be known: then
// all numbers are in the unit, and in SI without one.
[[nodiscard]] std::string format_posj(const PosJ& q, std::string_view style, std::string_view unit);

}  // namespace armlet::bind
