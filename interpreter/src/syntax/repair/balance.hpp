#pragma once
// Inserts missing brackets into the tokens of an incomplete text, so that it can be parsed.

#include "armlet/interpreter/source.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The tokens with all brackets closed, unchanged if the brackets match. An open bracket is closed
// before a closing bracket of an outer one, before a line that is indented no deeper than the line
// with the open bracket, or at the end of the text; closing brackets without an opening one are
// omitted. Inserted brackets have no text; their position is that of the token, line or end that
// they precede.
[[nodiscard]] Tokens balanced(const Source& source, const Tokens& tokens);

}  // namespace armlet::lang
