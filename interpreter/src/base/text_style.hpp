#pragma once
// How a formatted text writes a value: {x:+8.2f mm}.

#include <compare>
#include <cstdint>

namespace armlet::lang {

struct TextStyle {
  std::int8_t digits = -1;  // behind the point; -1: as `print` shows the number
  char notation = 0;        // 'f', 'e', 'g' or 0
  char align = 0;           // '<', '^', '>' or 0: numbers to the right, all else to the left
  bool sign = false;        // a plus in front of numbers that are not negative
  bool zeros = false;       // the width is filled with zeros behind the sign
  std::uint16_t width = 0;  // the fewest characters, the unit included

  // Says how many digits a number has.
  [[nodiscard]] bool has_digits() const { return digits >= 0 || notation != 0; }
  // Says something that only numbers have.
  [[nodiscard]] bool needs_number() const { return has_digits() || sign || zeros; }
  [[nodiscard]] bool is_plain() const { return !needs_number() && width == 0; }
  auto operator<=>(const TextStyle&) const = default;
};

// The largest width that can be written.
inline constexpr int kMostWidth = 1000;

}  // namespace armlet::lang
