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

// The place of a byte; one behind the end is the end, one inside of a character its start.
[[nodiscard]] TextPlace place_of(const Source& source, std::uint32_t byte);
// The byte of a place. Behind the end of a line is its end, behind the last line the end of the
// text; a place inside of a character is its start.
[[nodiscard]] std::uint32_t byte_of(const Source& source, TextPlace place);
// Nothing if it does not lie in the main text.
[[nodiscard]] std::optional<TextSpan> span_of(const SourceSet& sources, Span span);
// Units of UTF-16 in a text.
[[nodiscard]] int utf16_length(std::string_view text);

}  // namespace armlet::lab
