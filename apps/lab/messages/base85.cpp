#include "base85.hpp"

#include <algorithm>
#include <cstdint>

namespace armlet::lab {
namespace {

constexpr std::uint64_t kBase = 85;

char sign_of(std::uint64_t digit) { return static_cast<char>(digit + (digit < 20 ? 40 : 42)); }

// 85: the character is not a digit.
std::uint64_t digit_of(char sign) {
  if (sign < '(' || sign > '~' || sign == '<' || sign == '=') return kBase;
  return static_cast<std::uint64_t>(sign - (sign < '<' ? 40 : 42));
}

}  // namespace

std::string to_base85(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() / 4 * 5 + 5);
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(4, bytes.size()))) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = value << 8U | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    char signs[5];
    for (int k = 4; k >= 0; --k, value /= kBase) signs[k] = sign_of(value % kBase);
    text.append(signs, std::min<std::size_t>(4, bytes.size()) + 1);
  }
  return text;
}

std::optional<std::string> from_base85(std::string_view text) {
  if (text.size() % 5 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 5 * 4 + 4);
  for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(5, text.size()))) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      const std::uint64_t digit = k < text.size() ? digit_of(text[k]) : kBase - 1;
      if (digit == kBase) return std::nullopt;
      value = value * kBase + digit;
    }
    if (value > 0xFFFF'FFFF) return std::nullopt;
    const std::size_t count = std::min<std::size_t>(5, text.size()) - 1;
    for (std::size_t k = 0; k < count; ++k)
      bytes += static_cast<char>(value >> (24U - 8U * k) & 0xFFU);
  }
  return bytes;
}

bool is_text(std::string_view bytes) {
  std::size_t i = 0;
  const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
  while (i < bytes.size()) {
    const unsigned char c = at(i);
    const std::size_t more = c < 0x80 ? 0 : c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : 1;
    if (c == 0 || (c >= 0x80 && c < 0xC2) || c > 0xF4 || i + more >= bytes.size()) return false;
    for (std::size_t k = 1; k <= more; ++k) {
      if ((at(i + k) & 0xC0U) != 0x80) return false;
    }
    // Overlong, beyond U+10FFFF, or half of a surrogate pair.
    if ((c == 0xE0 && at(i + 1) < 0xA0) || (c == 0xED && at(i + 1) > 0x9F) ||
        (c == 0xF0 && at(i + 1) < 0x90) || (c == 0xF4 && at(i + 1) > 0x8F))
      return false;
    i += more + 1;
  }
  return true;
}

}  // namespace armlet::lab
