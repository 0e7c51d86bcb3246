#pragma once
// How text looks on a terminal: tabs, wide characters, characters without width, bytes that are no
// text.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// A line made safe to print, with the display column (from 0) of each of its bytes and of its end.
struct DisplayLine {
  std::string text;
  std::vector<int> columns;
};

// Tabs become spaces up to the next multiple of four; control characters and broken UTF-8 become
// U+FFFD.
[[nodiscard]] DisplayLine display_line(std::string_view line);

// The text alone. Line breaks stay if `keep_breaks`, otherwise they become spaces.
[[nodiscard]] std::string printable(std::string_view text, bool keep_breaks = false);

// The start of the character that the byte at `offset` belongs to.
[[nodiscard]] std::size_t character_start(std::string_view text, std::size_t offset);

}  // namespace armlet::lang
