#pragma once
// Characters (code points) in UTF-8, and the capital and small forms of letters.

#include <cstdint>
#include <string>
#include <string_view>

namespace armlet::bind {

[[nodiscard]] inline bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}
// How many characters a text has.
[[nodiscard]] std::int64_t characters(std::string_view text);
// Byte offset of character `index` >= 0; npos when the text is shorter than that.
[[nodiscard]] std::size_t offset_of(std::string_view text, std::int64_t index);

// The code point of the character at byte `at`; moves `at` behind it. Programs hold valid UTF-8
// only.
[[nodiscard]] char32_t next_character(std::string_view text, std::size_t& at);
void append_character(std::string& text, char32_t code);

// The text with every letter as a capital or a small letter: Latin with accents, Greek and
// Cyrillic, one character for one, the same everywhere whatever the machine's language. Letters
// without a single counterpart (such as the German sharp s, or the Turkish i without its dot) stay
// as they are.
//
// source  The Unicode Standard 15.0, UnicodeData.txt, simple case mappings.
[[nodiscard]] std::string with_case(std::string_view text, bool upper);

}  // namespace armlet::bind
