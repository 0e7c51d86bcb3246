#pragma once
// Brackets of a text that is being typed: what is missing is put in, so that the text can be read.

#include "armlet/interpreter/source.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The tokens with all brackets closed. If they match, they are as they were. Otherwise a bracket
// ends at a closer of something outside, before a line that is indented no deeper than the line
// that opens it, and at the end of the text; closers that belong to nothing are left out. What is
// put in has no text and stands in front of the token, the line or the end that it stands before.
[[nodiscard]] Tokens balanced(const Source& source, const Tokens& tokens);

}  // namespace armlet::lang
