#pragma once
// The text of a value: as `print` shows it, or in the format of a formatted text.

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

// Output beyond this is cut; whoever needs all of it asks for less.
inline constexpr std::size_t kNoLimit = SIZE_MAX;

// The fewest digits that read back to the same value, at most 15, with a point or an exponent:
// "2.0", "0.1", "1e-07".
[[nodiscard]] std::string number_text(double value);
// The same without a needless ".0": "2", "0.1"; as it stands before a unit.
[[nodiscard]] std::string bare_number_text(double value);
// "20 mm", "90 deg", "1.5 s": the unit is chosen by size.
[[nodiscard]] std::string quantity_text(double si, Dim dim);

// As `print` shows it: `2.0`, `[1.0, 2.0]`, `Pallet(corner: ..., rows: 2)`, `State.Idle`. Text
// stands without quotes, text inside lists and records in quotes. Stops adding once the text is
// longer than `limit`.
[[nodiscard]] std::string value_text(Slot value, const Type& type, std::size_t limit = kNoLimit);
// In a format, which applies to every number in the value.
[[nodiscard]] std::string format_value(Slot value, const Format& format,
                                       std::size_t limit = kNoLimit);
// The same at the end of a text of the program, counted as work. False: the failure is set.
[[nodiscard]] bool write_value(Vm& vm, TextMaker& text, Slot value, const Format& format);

}  // namespace armlet::lang
