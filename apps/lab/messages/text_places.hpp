#pragma once
// Positions of a text as pages count them: lines from 1, columns from 0 in UTF-16 units.

#include <cstdint>
#include <optional>

#include "armlet/interpreter/source.hpp"

namespace armlet::lab {

struct TextPlace {
  int line = 1;
  int column = 0;
  bool operator==(const TextPlace&) const = default;
};
struct TextSpan {
  TextPlace begin{};
  TextPlace end{};
  bool operator==(const TextSpan&) const = default;
};

// The position of a byte; beyond the end: the end; inside of a character: its start.
[[nodiscard]] TextPlace place_of(const Source& source, std::uint32_t byte);
// The byte of a position; beyond the end of a line: the end of the line; after the last line: the
// end of the text; inside of a character: the start of the character.
[[nodiscard]] std::uint32_t byte_of(const Source& source, TextPlace place);
// Nullopt if the span is not in the main text.
[[nodiscard]] std::optional<TextSpan> span_of(const SourceSet& sources, Span span);
// The length of a text in UTF-16 units.
[[nodiscard]] int utf16_length(std::string_view text);

}  // namespace armlet::lab
