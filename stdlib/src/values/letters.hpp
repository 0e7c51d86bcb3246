#pragma once
// Characters (code points) in UTF-8, and the upper and lower case of letters.

#include <cstdint>
#include <string>
#include <string_view>

namespace armlet::bind {

[[nodiscard]] inline bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}
// The number of characters of a text.
[[nodiscard]] std::int64_t characters(std::string_view text);
// The byte offset of character `index` >= 0; npos if the text is shorter.
[[nodiscard]] std::size_t offset_of(std::string_view text, std::int64_t index);

// The code point of the character at byte `at`; moves `at` to the next character. The text must be
// valid UTF-8, as texts of programs are.
[[nodiscard]] char32_t next_character(std::string_view text, std::size_t& at);
void append_character(std::string& text, char32_t code);

// The text in upper or lower case: Latin with accents, Greek and Cyrillic, one
// character for one, independent of the locale. Letters without a single
// counterpart (such as the German sharp s, or the Turkish i without its dot) do not
// change.
//
// source  The Unicode Standard 15.0, UnicodeData.txt, simple case mappings.
[[nodiscard]] std::string with_case(std::string_view text, bool upper);

}  // namespace armlet::bind
