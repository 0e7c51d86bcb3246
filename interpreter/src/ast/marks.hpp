#pragma once
// The punctuation marks and operators of the language, one row each, in the order of
// grammar/RbtLexer.g4 (language reference, section 3). The lexer's ends of statements, the tree,
// messages, the layout of chains and the operators of host types read these rows.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ast/ast_expr.hpp"

namespace armlet::lang {

struct Mark {
  std::string_view text;
  std::optional<ast::BinaryOp> operation{};  // of its two sides
  bool assigns = false;                      // the result is stored in the left side
  bool joins = false;                        // has a value at both sides, but no operation
  int chain = 0;             // level of chains that are broken over lines; 0: never broken
  bool goes_on = false;      // a line that begins with it continues the statement above
  bool ends = false;         // a statement may end behind it
  std::string_view wants{};  // the part that has to follow it
};

// clang-format off
inline constexpr Mark kMarkRows[] = {
    {.text = "{"},
    {.text = "}", .ends = true},
    {.text = "(", .goes_on = true, .wants = "a value"},
    {.text = ")", .goes_on = true, .ends = true},
    {.text = "[", .goes_on = true, .wants = "a value"},
    {.text = "]", .goes_on = true, .ends = true},
    {.text = ";", .goes_on = true},
    {.text = ",", .goes_on = true, .wants = "a value"},
    {.text = ".", .joins = true, .goes_on = true, .wants = "a name"},
    {.text = ":", .goes_on = true, .wants = "a value"},
    {.text = "?", .joins = true, .goes_on = true, .wants = "a value"},
    {.text = "->", .goes_on = true, .wants = "a type"},
    {.text = "=>", .goes_on = true, .wants = "a value"},
    {.text = "==", .operation = ast::BinaryOp::kEq, .chain = 3, .goes_on = true, .wants = "a value"},
    {.text = "!=", .operation = ast::BinaryOp::kNe, .chain = 3, .goes_on = true, .wants = "a value"},
    {.text = "<=", .operation = ast::BinaryOp::kLessEq, .chain = 4, .goes_on = true, .wants = "a value"},
    {.text = ">=", .operation = ast::BinaryOp::kGreaterEq, .chain = 4, .goes_on = true, .wants = "a value"},
    {.text = "<", .operation = ast::BinaryOp::kLess, .chain = 4, .goes_on = true, .wants = "a value"},
    {.text = ">", .operation = ast::BinaryOp::kGreater, .chain = 4, .goes_on = true, .wants = "a value"},
    {.text = "&&", .operation = ast::BinaryOp::kAnd, .chain = 2, .goes_on = true, .wants = "a value"},
    {.text = "||", .operation = ast::BinaryOp::kOr, .chain = 1, .goes_on = true, .wants = "a value"},
    {.text = "!", .wants = "a value"},
    {.text = "+=", .operation = ast::BinaryOp::kAdd, .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "-=", .operation = ast::BinaryOp::kSub, .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "*=", .operation = ast::BinaryOp::kMul, .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "/=", .operation = ast::BinaryOp::kDiv, .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "%=", .operation = ast::BinaryOp::kMod, .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "=", .assigns = true, .goes_on = true, .wants = "a value"},
    {.text = "++", .ends = true},
    {.text = "--", .ends = true},
    {.text = ".*", .operation = ast::BinaryOp::kElemMul, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = "./", .operation = ast::BinaryOp::kElemDiv, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = ".^", .operation = ast::BinaryOp::kElemPow, .goes_on = true, .wants = "a value"},
    {.text = "+", .operation = ast::BinaryOp::kAdd, .chain = 5, .goes_on = true, .wants = "a value"},
    {.text = "-", .operation = ast::BinaryOp::kSub, .chain = 5, .goes_on = true, .wants = "a value"},
    {.text = "*", .operation = ast::BinaryOp::kMul, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = "/", .operation = ast::BinaryOp::kDiv, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = "%", .operation = ast::BinaryOp::kMod, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = "\\", .operation = ast::BinaryOp::kLeftDiv, .chain = 6, .goes_on = true, .wants = "a value"},
    {.text = "^", .operation = ast::BinaryOp::kPow, .goes_on = true, .wants = "a value"},
};
inline constexpr Mark kNoMark{};
// clang-format on

// The number of the first mark among the kinds of tokens; the marks follow in the order of the
// rows. token_kinds.hpp checks the numbers at compile time.
inline constexpr std::size_t kFirstMark = 50;
inline constexpr std::size_t kBehindMarks = kFirstMark + std::size(kMarkRows);

// The row of a kind of token; a row without properties for tokens that are no marks.
[[nodiscard]] constexpr const Mark& mark_of(std::size_t token) {
  return token >= kFirstMark && token < kBehindMarks ? kMarkRows[token - kFirstMark] : kNoMark;
}

// The row of a mark given by its text; a row without properties if the text is no mark.
[[nodiscard]] constexpr const Mark& find_mark(std::string_view text) {
  const Mark* found = std::ranges::find(kMarkRows, text, &Mark::text);
  return found == std::end(kMarkRows) ? kNoMark : *found;
}

// Whether the mark is a binary operator in the middle of values: a + b, a < b, a.b, a ? b : c.
// Assignments are not.
[[nodiscard]] constexpr bool is_between_values(const Mark& mark) {
  return mark.joins || (mark.operation && !mark.assigns);
}

// Whether a host can define the operator for types of its own.
[[nodiscard]] constexpr bool is_arithmetic(const Mark& mark) {
  return mark.operation && !mark.assigns && *mark.operation <= ast::BinaryOp::kElemPow;
}

}  // namespace armlet::lang
