#pragma once
// Converts indices, ranges, angles and percentages of other languages.

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lang {

// Whether the text is a number without a unit: 12, -0.5, 1.
[[nodiscard]] bool is_plain_number(std::string_view text);
// Adds a unit to numbers, and multiplies other values by it: 5mm, a * 1mm.
[[nodiscard]] std::string with_unit(const std::string& value, const std::string& unit);

// Converts an index that counts from 1: `i` to `i - 1`; 2:3, which includes its end, to `2 - 1:3`.
// Empty for 0 and for `end`.
[[nodiscard]] std::optional<std::string> index_from_zero(const std::string& part);
// "a, b" for a:b: the arguments of `range` for a, a + 1 ... up to b.
[[nodiscard]] std::optional<std::string> counted_range(const std::string& part);
// "a, step, b" for a:step:b. The step must be a number, because its sign decides which end is
// excluded.
[[nodiscard]] std::optional<std::string> stepped_range(const std::string& part);
// Converts "a, 'deg'" or "a, 'rad'" to the angle with its unit; empty for another word.
[[nodiscard]] std::optional<std::string> angle_with_word(const std::string& part);
// An angle in radians; empty for more than one revolution, which was meant in degrees.
[[nodiscard]] std::optional<std::string> small_angle(const std::string& part);
// Converts KRL's Vel=50 % to ", speed: 50 / 100.0"; "" for the full speed.
[[nodiscard]] std::optional<std::string> share_of_speed(const std::string& part);

}  // namespace armlet::lang
