#pragma once
// A syntax tree as text, without spans: programs that mean the same have the same text.

#include <string>

#include "syntax/parse.hpp"

namespace armlet::lang {

// One line for each statement: `<KIND ...>` with the number of its kind; operators as `op` and
// their number.
[[nodiscard]] std::string dump(const Parsed& parsed);

// Parses a text that must be right and dumps it; the messages, if it is not.
[[nodiscard]] std::string dump(const std::string& text);

}  // namespace armlet::lang
