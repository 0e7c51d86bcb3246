#pragma once
// Poses in formatted texts: f"{p:.2f mm}".

#include <string_view>

#include "armlet/interpreter/answer.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// As `print` shows it, with each number in the style, a format of fmt ("+8.2f"). A unit of length
// applies to the position, a unit of angle to the orientation; the other numbers are in mm and
// deg.
[[nodiscard]] std::string format_posc(const PosC& p, std::string_view style, std::string_view unit);
// The text of joint values of revolute and prismatic joints. If the kinds of the joints are
// unknown, all numbers are in the unit, or in SI without a unit.
[[nodiscard]] std::string format_posj(const PosJ& q, std::string_view style, std::string_view unit);

}  // namespace armlet::bind
