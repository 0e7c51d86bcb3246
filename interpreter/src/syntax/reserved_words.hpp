#pragma once
// What may be a name (language reference, section 3).

#include <algorithm>
#include <array>
#include <string_view>

namespace armlet::lang {

inline constexpr auto kReservedWords = std::to_array<std::string_view>(
    {"let",   "var",     "fn",       "struct",   "enum",   "import", "final", "void",
     "new",   "if",      "else",     "while",    "do",     "for",    "in",    "switch",
     "case",  "default", "break",    "continue", "return", "try",    "catch", "finally",
     "throw", "retry",   "parallel", "when",     "every",  "wait",   "until", "with",
     "true",  "false",   "int",      "long",     "double", "float",  "bool",  "boolean"});

[[nodiscard]] inline bool is_reserved_word(std::string_view word) {
  return std::ranges::find(kReservedWords, word) != kReservedWords.end();
}

// A byte that can be part of a name; letters beyond ASCII consist of such bytes.
[[nodiscard]] inline bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

}  // namespace armlet::lang
