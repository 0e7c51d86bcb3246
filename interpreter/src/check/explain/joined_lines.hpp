#pragma once
// Explains lines that start with ( or [ and therefore continue the value of the line above.

#include "check/state/checker.hpp"

namespace armlet::lang {

// The bracket of a call or an index that begins a line; empty otherwise.
[[nodiscard]] Joined joined_line(const Checker& checker, const ast::Expr& expr);
// Adds a note about the innermost of these lines to a message whose mark begins in it.
void tell_of_joined_lines(const std::vector<Joined>& joined, Diagnostic& diagnostic);

}  // namespace armlet::lang
