#include "storyboard/lettering.hpp"

#include <cstddef>
#include <utility>

namespace armlet::cli {
namespace {

// A letter: its picture, and offsets in pixels from the pen position and from the top of the line.
struct Glyph {
  int width, height, left, top;
  int advance;
  const char* ink;  // row by row, 0 to f
};

constexpr Glyph kGlyphs[] = {
#include "storyboard/glyphs.inc"
};

const Glyph& glyph_of(unsigned code) {
  constexpr unsigned kFirst = 0x20, kLast = 0x7E, kFirstAbove = 0xA0, kLastAbove = 0xFF;
  if (code >= kFirst && code <= kLast) return kGlyphs[code - kFirst];
  if (code >= kFirstAbove && code <= kLastAbove)
    return kGlyphs[code - kFirstAbove + kLast - kFirst + 1];
  return kGlyphs['?' - kFirst];
}

// The code of a character and the position of the next one.
std::pair<unsigned, std::size_t> character(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  if (byte < 0x80U) return {byte, at + 1};
  const bool two = byte >= 0xC2U && byte <= 0xC3U && at + 1 < text.size();
  const unsigned code =
      two ? (byte & 0x1FU) << 6U | (static_cast<unsigned char>(text[at + 1]) & 0x3FU) : 0;
  std::size_t next = at + 1;
  while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0U) == 0x80U) ++next;
  return {code, next};
}

int level_of(char ink) { return ink <= '9' ? ink - '0' : ink - 'a' + 10; }

void lay(Image& image, int left, int top, const Glyph& glyph, int grey) {
  constexpr int kFull = 15;
  for (int y = 0; y < glyph.height; ++y) {
    const int at_y = top + glyph.top + y;
    if (at_y < 0 || at_y >= image.height()) continue;
    for (int x = 0; x < glyph.width; ++x) {
      const int at_x = left + glyph.left + x;
      if (at_x < 0 || at_x >= image.width()) continue;
      const int ink = level_of(glyph.ink[y * glyph.width + x]);
      std::uint8_t* pixel = image.row(at_y) + at_x * image.channels();
      for (int c = 0; c < image.channels(); ++c)
        pixel[c] = static_cast<std::uint8_t>((pixel[c] * (kFull - ink) + grey * ink) / kFull);
    }
  }
}

}  // namespace

int width_of(std::string_view text) {
  int width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, next] = character(text, at);
    width += glyph_of(code).advance;
    at = next;
  }
  return width;
}

std::string fitted(std::string_view text, int width) {
  if (width_of(text) <= width) return std::string(text);
  constexpr std::string_view kRest = "...";
  std::size_t end = 0;
  for (std::size_t at = 0; at < text.size();) {
    at = character(text, at).second;
    if (width_of(text.substr(0, at)) + width_of(kRest) > width) break;
    end = at;
  }
  return std::string(text.substr(0, end)) += kRest;
}

void write(Image& image, int left, int top, std::string_view text, std::uint8_t grey) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, next] = character(text, at);
    const Glyph& glyph = glyph_of(code);
    lay(image, left, top, glyph, grey);
    left += glyph.advance;
    at = next;
  }
}

}  // namespace armlet::cli
