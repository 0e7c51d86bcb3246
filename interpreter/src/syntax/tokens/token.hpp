#pragma once
// One token of a text, without anything of ANTLR: what the filter, the bracket check and the
// messages work on.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "armlet/interpreter/source.hpp"

namespace armlet::lang {

struct Token {
  std::uint32_t begin = 0;  // bytes in the source
  std::uint32_t end = 0;
  std::uint16_t type = 0;          // RbtLexer::ID, ...; kEndOfText at the end
  bool line_break_before = false;  // between it and the token before
  bool inserted = false;           // a `;` that stands for the end of a line
};

inline constexpr std::uint16_t kEndOfText = 0xFFFF;

// Always ends with one kEndOfText.
using Tokens = std::vector<Token>;

}  // namespace armlet::lang
