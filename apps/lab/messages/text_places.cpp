#include "text_places.hpp"

#include <algorithm>
#include <string_view>

namespace armlet::lab {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Characters of four bytes are surrogate pairs in UTF-16.
int units_of(char first) { return static_cast<unsigned char>(first) >= 0xF0U ? 2 : 1; }

}  // namespace

int utf16_length(std::string_view text) {
  int units = 0;
  for (const char c : text) {
    if (!continues(c)) units += units_of(c);
  }
  return units;
}

TextPlace place_of(const Source& source, std::uint32_t byte) {
  const std::string_view text = source.text();
  std::size_t at = std::min<std::size_t>(byte, text.size());
  while (at > 0 && at < text.size() && continues(text[at])) --at;
  const int line = source.position(static_cast<std::uint32_t>(at)).line;
  const std::uint32_t start = source.line_start(line);
  return {line, utf16_length(text.substr(start, at - start))};
}

std::uint32_t byte_of(const Source& source, TextPlace place) {
  if (place.line < 1) return 0;
  if (place.line > source.line_count()) return static_cast<std::uint32_t>(source.text().size());
  const std::string_view line = source.line(place.line);
  std::size_t at = 0;
  int column = 0;
  while (at < line.size()) {
    const int units = units_of(line[at]);
    if (column + units > place.column) break;
    column += units;
    ++at;
    while (at < line.size() && continues(line[at])) ++at;
  }
  return source.line_start(place.line) + static_cast<std::uint32_t>(at);
}

std::optional<TextSpan> span_of(const SourceSet& sources, Span span) {
  if (span.source != sources.first()) return std::nullopt;
  const Source& source = sources[span.source];
  return TextSpan{place_of(source, span.begin), place_of(source, span.end)};
}

}  // namespace armlet::lab
