#pragma once
// Converts text for a terminal: tabs, wide characters, characters without width, invalid bytes.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// A line that is safe to print, with the display column, from 0, of each of its bytes and of its
// end.
struct DisplayLine {
  std::string text;
  std::vector<int> columns;
};

// Makes a line safe to print: tabs become spaces up to the next multiple of four; control
// characters and invalid UTF-8 become U+FFFD.
[[nodiscard]] DisplayLine display_line(std::string_view line);

// The text alone. Line breaks are kept if `keep_breaks`, otherwise they become spaces.
[[nodiscard]] std::string printable(std::string_view text, bool keep_breaks = false);

// The first byte of the character with the byte at `offset`.
[[nodiscard]] std::size_t character_start(std::string_view text, std::size_t offset);

}  // namespace armlet::lang
