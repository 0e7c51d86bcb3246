#pragma once
// What fixes write: values that become part of others, and statements that go somewhere else, laid
// out like the text around them.

#include <string>
#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The text of a value, in parentheses if it is made by an operator: to be multiplied or divided.
[[nodiscard]] std::string as_operand(const std::string& text);
// Whether a value is written as a decimal number and nothing else.
[[nodiscard]] bool is_decimal_number(std::string_view text);

// Puts a statement at the end of the block that `brace` closes.
[[nodiscard]] Edit at_end_of_block(const Checker& checker, Span brace,
                                   const std::string& statement);
// Moves a statement that stands alone on its lines in front of the place `to`, which stands first
// on its line. Empty if either does not.
[[nodiscard]] std::vector<Edit> moved_before(const Checker& checker, Span statement, Span to);

}  // namespace armlet::lang
