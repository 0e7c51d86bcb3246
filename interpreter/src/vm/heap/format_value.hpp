#pragma once
// Converts values to text: as `print` shows them, or in the format of a formatted text.

#include <cstddef>
#include <cstdint>
#include <string>

#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"
#include "program/program.hpp"

namespace armlet {
class TextMaker;
class Vm;
}  // namespace armlet

namespace armlet::lang {

// Texts are cut at this length; callers that need less give a lower limit.
inline constexpr std::size_t kNoLimit = SIZE_MAX;

// The fewest digits that read back to the same value, at most 15, with a point or an exponent:
// "2.0", "0.1", "1e-07".
[[nodiscard]] std::string number_text(double value);
// The text of a number without ".0" at the end: "2", "0.1"; used before a unit.
[[nodiscard]] std::string bare_number_text(double value);
// The text of a quantity, whose unit is chosen by size: "20 mm", "90 deg", "1.5 s".
[[nodiscard]] std::string quantity_text(double si, Dim dim);

// The text of a value as `print` shows it: `2.0`, `[1.0, 2.0]`, `Pallet(corner: ..., rows: 2)`,
// `State.Idle`. A text has quotes only inside lists and records. The function stops once the text
// is longer than `limit`.
[[nodiscard]] std::string value_text(Slot value, const Type& type, std::size_t limit = kNoLimit);
// The text of a value in a format, which applies to every number in the value.
[[nodiscard]] std::string format_value(Slot value, const Format& format,
                                       std::size_t limit = kNoLimit);
// Appends a value in a format to a text of the program, counted as work. Returns false, with the
// failure set, if that fails.
// that fails.
[[nodiscard]] bool write_value(Vm& vm, TextMaker& text, Slot value, const Format& format);

}  // namespace armlet::lang
