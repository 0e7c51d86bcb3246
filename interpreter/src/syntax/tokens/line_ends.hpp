#pragma once
// Inserts the ends of statements that have no `;` (language reference, section 3.1).

#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The tokens with a `;` inserted wherever a line end, a closing brace, an `else` or the end of the
// text ends a statement. An inserted token has no text; its position is the end of the token before
// it.
[[nodiscard]] Tokens insert_line_ends(const Tokens& tokens);

// Whether the text may be a complete input of the prompt: every bracket is closed and a statement
// ends at its end.
[[nodiscard]] bool could_end_here(const Tokens& tokens);
// Whether a statement ends before the first token at or after the byte.
[[nodiscard]] bool ends_before(const Tokens& tokens, std::uint32_t byte);

}  // namespace armlet::lang
