#pragma once

#include <string>

namespace armlet {

// The bit of each dot of a braille character: 4 rows of 2 dots (Unicode, U+2800 to U+28FF).
inline constexpr unsigned kDotBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};

// Appends the character with these dots in UTF-8; without dots a blank.
inline void append_dots(std::string& out, unsigned bits) {
  if (bits == 0) {
    out += ' ';
    return;
  }
  const unsigned code = 0x2800U + bits;
  out += static_cast<char>(0xE0U | (code >> 12U));
  out += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
  out += static_cast<char>(0x80U | (code & 0x3FU));
}

}  // namespace armlet
