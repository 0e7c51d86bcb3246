#pragma once
// Messages about pieces of text that are no tokens.

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet::lang {

// A quote that is not closed on its line; `text` runs from the quote to the end of the line.
[[nodiscard]] Diagnostic unclosed_text(const Source& source, Span text);

// `/*` without `*/`.
[[nodiscard]] Diagnostic unclosed_comment(const Source& source, Span opening);

// A number with letters that are no unit: 5cmm.
[[nodiscard]] Diagnostic bad_number(const Source& source, Span number);

// A character that the language does not use: a word processor's quote, `#`, `&` ...
[[nodiscard]] Diagnostic bad_character(const Source& source, Span character);

}  // namespace armlet::lang
