#pragma once
// Indexes, ranges, angles and shares of other languages, as they are written here.

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lang {

// 12, -0.5, 1.
[[nodiscard]] bool is_plain_number(std::string_view text);
// Numbers get the unit, other values are multiplied with it: 5mm, a * 1mm.
[[nodiscard]] std::string with_unit(const std::string& value, const std::string& unit);

// An index that counts from 1: `i - 1`; of 2:3, whose end belongs to it, `2 - 1:3`. Nothing for 0
// and for `end`.
[[nodiscard]] std::optional<std::string> index_from_zero(const std::string& part);
// "a, b" of a:b: what `range` takes for a, a + 1 ... up to b.
[[nodiscard]] std::optional<std::string> counted_range(const std::string& part);
// "a, step, b" of a:step:b. The step has to be a number: which end is left out depends on its sign.
[[nodiscard]] std::optional<std::string> stepped_range(const std::string& part);
// "a, 'deg'" or "a, 'rad'": the angle with its unit; nothing for another word.
[[nodiscard]] std::optional<std::string> angle_with_word(const std::string& part);
// An angle in radians; nothing for more than a revolution, which was meant in degrees.
[[nodiscard]] std::optional<std::string> small_angle(const std::string& part);
// KRL's Vel=50 %: ", speed: 50 / 100.0"; "" for the full speed.
[[nodiscard]] std::optional<std::string> share_of_speed(const std::string& part);

}  // namespace armlet::lang
