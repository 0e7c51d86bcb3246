#pragma once
// Whether bytes are a text.

#include <cstddef>
#include <optional>
#include <string_view>

namespace armlet::lang {

// The first byte that is no part of a character in UTF-8; nothing: all are. Programs hold no other
// texts.
[[nodiscard]] std::optional<std::size_t> broken_byte(std::string_view text);

// Whether a code point begins with this byte of a text in UTF-8.
[[nodiscard]] inline bool starts_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace armlet::lang
