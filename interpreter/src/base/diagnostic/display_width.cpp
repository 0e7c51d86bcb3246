#include "base/diagnostic/display_width.hpp"

#include <algorithm>
#include <cstdint>

namespace armlet::lang {
namespace {

constexpr std::string_view kReplacement = "\uFFFD";
constexpr int kTab = 4;

struct Character {
  char32_t code = 0;
  std::size_t size = 1;
  bool good = false;
};

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Reads one UTF-8 character. Overlong forms and surrogates are invalid.
Character read_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {};
  char32_t code = lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if (!is_continuation(text[i])) return {};
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  constexpr char32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kSmallest[size] || code > 0x10FFFF || surrogate) return {};
  return {code, size, true};
}

struct Range {
  char32_t first;
  char32_t last;
};

// Combining marks, joiners and selectors, which have no width.
constexpr Range kZero[] = {
    {0x0300, 0x036F}, {0x200B, 0x200F}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}};
// East Asian wide characters and emoji, which are two columns wide.
constexpr Range kWide[] = {
    {0x1100, 0x115F}, {0x2E80, 0x303E},   {0x3041, 0x33FF},   {0x3400, 0x4DBF},  {0x4E00, 0x9FFF},
    {0xA000, 0xA4CF}, {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},  {0xFF00, 0xFF60},
    {0xFFE0, 0xFFE6}, {0x1F300, 0x1F64F}, {0x1F900, 0x1F9FF}, {0x20000, 0x3FFFD}};

template <std::size_t N>
bool contains(const Range (&ranges)[N], char32_t code) {
  return std::ranges::any_of(
      ranges, [code](const Range& range) { return code >= range.first && code <= range.last; });
}

// Control characters: C0, DEL, C1, and the marks that reverse the direction of the text after them.
bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code <= 0x9F) || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

int width(char32_t code) { return contains(kZero, code) ? 0 : contains(kWide, code) ? 2 : 1; }

}  // namespace

DisplayLine display_line(std::string_view line) {
  DisplayLine out;
  out.columns.reserve(line.size() + 1);
  int column = 0;
  for (std::size_t at = 0; at < line.size();) {
    const Character c = read_character(line.substr(at));
    out.columns.insert(out.columns.end(), c.size, column);
    if (c.good && c.code == '\t') {
      const int spaces = kTab - column % kTab;
      out.text.append(static_cast<std::size_t>(spaces), ' ');
      column += spaces;
    } else if (!c.good || is_control(c.code)) {
      out.text += kReplacement;
      ++column;
    } else {
      out.text += line.substr(at, c.size);
      column += width(c.code);
    }
    at += c.size;
  }
  out.columns.push_back(column);
  return out;
}

std::string printable(std::string_view text, bool keep_breaks) {
  std::string out;
  while (true) {
    const std::size_t end = text.find('\n');
    out += display_line(text.substr(0, end)).text;
    if (end == std::string_view::npos) return out;
    out += keep_breaks ? '\n' : ' ';
    text.remove_prefix(end + 1);
  }
}

std::size_t character_start(std::string_view text, std::size_t offset) {
  while (offset > 0 && offset < text.size() && is_continuation(text[offset])) --offset;
  return offset;
}

}  // namespace armlet::lang
