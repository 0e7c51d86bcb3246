#pragma once
// Messages about the reason why the parser could not continue, with the words of the program
// (language reference, section 20.3, E01xx).

#include "armlet/interpreter/diagnostic.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The message for a statement that starts at token `statement` and cannot continue at token `at`.
// `tokens` contain the inserted ends of statements; all brackets match.
[[nodiscard]] Diagnostic explain_failure(const Source& source, const Tokens& tokens,
                                         std::size_t statement, std::size_t at);

// The token after the indented lines of `def f(x):`, which the parser cannot read without the
// header; 0 if the statement is no such function.
[[nodiscard]] std::size_t end_of_python_function(const Source& source, const Tokens& tokens,
                                                 std::size_t statement, std::size_t at);
// The token after `repeat { ... } until (c)`, `repeat 3 { ... }` or `loop { ... }`; 0 if the
// statement is none of these.
[[nodiscard]] std::size_t end_of_foreign_loop(const Source& source, const Tokens& tokens,
                                              std::size_t statement, std::size_t at);

}  // namespace armlet::lang
