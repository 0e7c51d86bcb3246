#pragma once
// The format of a value in a formatted text: {x:+8.2f mm}.

#include <compare>
#include <cstdint>

namespace armlet::lang {

struct TextStyle {
  std::int8_t digits = -1;  // after the point; -1: as `print` shows the number
  char notation = 0;        // 'f', 'e', 'g' or 0
  char align = 0;           // '<', '^', '>' or 0: numbers right, other values left
  bool sign = false;        // a plus before numbers that are not negative
  bool zeros = false;       // zeros after the sign fill the width
  std::uint16_t width = 0;  // the fewest characters, the unit included

  // Whether the format sets the number of digits.
  [[nodiscard]] bool has_digits() const { return digits >= 0 || notation != 0; }
  // Whether the format is valid for numbers only.
  [[nodiscard]] bool needs_number() const { return has_digits() || sign || zeros; }
  [[nodiscard]] bool is_plain() const { return !needs_number() && width == 0; }
  auto operator<=>(const TextStyle&) const = default;
};

// The largest width that a format may have.
inline constexpr int kMostWidth = 1000;

}  // namespace armlet::lang
