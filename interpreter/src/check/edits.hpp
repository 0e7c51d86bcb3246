#pragma once
// Edits of fixes that put a statement somewhere else, laid out like the text around them.

#include <string>

#include "check/checker.hpp"

namespace armlet::lang {

// Puts a statement at the end of the block that `brace` closes.
[[nodiscard]] Edit at_end_of_block(const Checker& checker, Span brace,
                                   const std::string& statement);
// Moves a statement that stands alone on its lines in front of the place `to`, which stands first
// on its line. Empty if either does not.
[[nodiscard]] std::vector<Edit> moved_before(const Checker& checker, Span statement, Span to);

}  // namespace armlet::lang
