#pragma once
// One token of a text, independent of ANTLR, for the insertion of line ends, the bracket check and
// the messages.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "armlet/interpreter/source.hpp"

namespace armlet::lang {

struct Token {
  std::uint32_t begin = 0;  // in the source
  std::uint32_t end = 0;
  std::uint16_t type = 0;          // RbtLexer::ID, ...; kEndOfText at the end
  bool line_break_before = false;  // since the token before
  bool inserted = false;           // a `;` for the end of a line
};

inline constexpr std::uint16_t kEndOfText = 0xFFFF;

// Always ends with one kEndOfText.
using Tokens = std::vector<Token>;

}  // namespace armlet::lang
