#pragma once
// Messages about invalid tokens.

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet::lang {

// The message for a quote that is not closed on its line; `text` is the rest of the line from the
// quote on.
[[nodiscard]] Diagnostic unclosed_text(const Source& source, Span text);

// The message for `/*` without `*/`.
[[nodiscard]] Diagnostic unclosed_comment(const Source& source, Span opening);

// The message for a number with letters that are no unit: 5cmm.
[[nodiscard]] Diagnostic bad_number(const Source& source, Span number);

// The message for a character that the language does not use: a word processor's quote, `#`, `&`
// ...
[[nodiscard]] Diagnostic bad_character(const Source& source, Span character);

}  // namespace armlet::lang
