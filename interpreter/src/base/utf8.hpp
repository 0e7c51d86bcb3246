#pragma once
// Checks of UTF-8.

#include <cstddef>
#include <optional>
#include <string_view>

namespace armlet::lang {

// The position of the first byte that is not part of a UTF-8 character; empty if there is none.
// Texts of programs are valid UTF-8.
[[nodiscard]] std::optional<std::size_t> broken_byte(std::string_view text);

// Whether a code point begins with this byte of a UTF-8 text.
[[nodiscard]] inline bool starts_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace armlet::lang
