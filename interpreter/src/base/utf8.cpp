#include "base/utf8.hpp"

#include <cstdint>

namespace armlet::lang {

std::optional<std::size_t> broken_byte(std::string_view text) {
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};  // by length
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if ((lead >= 0x80 && lead < 0xC2) || lead > 0xF4 || size > text.size() - at) return at;
    std::uint32_t code = size == 1 ? lead : lead & (0x7FU >> size);
    for (std::size_t i = 1; i < size; ++i) {
      if (!starts_character(text[at + i])) {
        code = code << 6U | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
      } else {
        return at;
      }
    }
    const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kSmallest[size] || code > 0x10FFFF || is_surrogate) return at;
    at += size;
  }
  return std::nullopt;
}

}  // namespace armlet::lang
