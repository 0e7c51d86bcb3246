#include "values/letters.hpp"

#include <algorithm>
#include <iterator>

namespace armlet::bind {
namespace {

// Lower-case letters from first to last whose capitals are `shift` below; with kNeighbours: every
// second character, with its capital just before it.
struct Letters {
  char32_t first;
  char32_t last;
  std::int32_t shift;
};
constexpr std::int32_t kNeighbours = 1;

constexpr Letters kLetters[] = {
    {U'a', U'z', 32},
    {0x00E0, 0x00F6, 32},
    {0x00F8, 0x00FE, 32},
    {0x00FF, 0x00FF, -121},
    {0x0101, 0x012F, kNeighbours},
    {0x0133, 0x0137, kNeighbours},
    {0x013A, 0x0148, kNeighbours},
    {0x014B, 0x0177, kNeighbours},
    {0x017A, 0x017E, kNeighbours},
    {0x01CE, 0x01DC, kNeighbours},
    {0x01DF, 0x01EF, kNeighbours},
    {0x01F9, 0x021F, kNeighbours},
    {0x0223, 0x0233, kNeighbours},
    {0x0247, 0x024F, kNeighbours},
    {0x0371, 0x0373, kNeighbours},
    {0x0377, 0x0377, kNeighbours},
    {0x03AC, 0x03AC, 38},
    {0x03AD, 0x03AF, 37},
    {0x03B1, 0x03C1, 32},
    {0x03C3, 0x03CB, 32},
    {0x03CC, 0x03CC, 64},
    {0x03CD, 0x03CE, 63},
    {0x03D9, 0x03EF, kNeighbours},
    {0x0430, 0x044F, 32},
    {0x0450, 0x045F, 80},
    {0x0461, 0x0481, kNeighbours},
    {0x048B, 0x04BF, kNeighbours},
    {0x04C2, 0x04CE, kNeighbours},
    {0x04D1, 0x052F, kNeighbours},
};

bool is_small(const Letters& letters, char32_t code) {
  if (code < letters.first || code > letters.last) return false;
  return letters.shift != kNeighbours || (code - letters.first) % 2 == 0;
}

char32_t capital_of(char32_t code) {
  if (code == 0x03C2) return 0x03A3;  // the sigma at the end of a word
  for (const Letters& letters : kLetters) {
    if (is_small(letters, code))
      return static_cast<char32_t>(static_cast<std::int32_t>(code) - letters.shift);
  }
  return code;
}

char32_t small_of(char32_t code) {
  for (const Letters& letters : kLetters) {
    const auto small = static_cast<char32_t>(static_cast<std::int32_t>(code) + letters.shift);
    if (is_small(letters, small)) return small;
  }
  return code;
}

}  // namespace

std::int64_t characters(std::string_view text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); });
}

std::size_t offset_of(std::string_view text, std::int64_t index) {
  std::int64_t seen = -1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_continuation(text[i]) && ++seen == index) return i;
  }
  return seen + 1 == index ? text.size() : std::string_view::npos;
}

char32_t next_character(std::string_view text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  char32_t code = lead < 0x80U   ? lead
                  : lead < 0xE0U ? lead & 0x1FU
                  : lead < 0xF0U ? lead & 0x0FU
                                 : lead & 0x07U;
  for (; at < text.size() && is_continuation(text[at]); ++at)
    code = code << 6U | (static_cast<unsigned char>(text[at]) & 0x3FU);
  return code;
}

void append_character(std::string& text, char32_t code) {
  const auto part = [&](unsigned shift) {
    return static_cast<char>(0x80U | (code >> shift & 0x3FU));
  };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += {static_cast<char>(0xC0U | code >> 6U), part(0)};
  } else if (code < 0x10000) {
    text += {static_cast<char>(0xE0U | code >> 12U), part(6), part(0)};
  } else {
    text += {static_cast<char>(0xF0U | code >> 18U), part(12), part(6), part(0)};
  }
}

std::string with_case(std::string_view text, bool upper) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const char32_t code = next_character(text, at);
    append_character(out, upper ? capital_of(code) : small_of(code));
  }
  return out;
}

}  // namespace armlet::bind
