#pragma once
// A line that starts with ( or [ goes on with the value of the line above.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Of a call or an index whose bracket stands on a line of its own; empty otherwise.
[[nodiscard]] Joined joined_line(const Checker& checker, const ast::Expr& expr);
// Says so in a message whose mark begins in the innermost of them.
void tell_of_joined_lines(const std::vector<Joined>& joined, Diagnostic& diagnostic);

}  // namespace armlet::lang
