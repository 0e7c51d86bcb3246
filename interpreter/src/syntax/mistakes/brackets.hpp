#pragma once
// The check of brackets. If one is missing, the indentation shows which (language reference,
// section 20.2).

#include <optional>

#include "armlet/interpreter/diagnostic.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The message about the first bracket that is missing, superfluous or of the wrong kind; empty if
// all brackets match.
[[nodiscard]] std::optional<Diagnostic> check_brackets(const Source& source, const Tokens& tokens);

}  // namespace armlet::lang
