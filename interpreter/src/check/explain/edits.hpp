#pragma once
// Edits for fixes: they insert values into expressions and move statements, with the layout of the
// text around them.

#include <string>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The text of a value as a factor or divisor: in parentheses if it is the result of an operator.
[[nodiscard]] std::string as_operand(const std::string& text);
// Whether the text is just a decimal number.
[[nodiscard]] bool is_decimal_number(std::string_view text);

// Inserts a statement at the end of the block that `brace` closes.
[[nodiscard]] Edit at_end_of_block(const Checker& checker, Span brace,
                                   const std::string& statement);
// Moves a statement that has its lines for itself before the position `to`, which must be the first
// of its line. Empty if one of these conditions is not met.
[[nodiscard]] std::vector<Edit> moved_before(const Checker& checker, Span statement, Span to);

}  // namespace armlet::lang
