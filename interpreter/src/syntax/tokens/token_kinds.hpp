#pragma once
// Properties of kinds of tokens that several stages use.

#include <RbtLexer.h>

#include "ast/marks.hpp"
#include "base/words.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

static_assert(RbtLexer::LET == 1 && RbtLexer::AS + 1 == kWordTokens);
static_assert(RbtLexer::LBRACE == kFirstMark && RbtLexer::CARET + 1 == kBehindMarks);

[[nodiscard]] inline bool is_name(std::uint16_t type) {
  return type == RbtLexer::ID || word_of(type).kind == WordKind::kSoft;
}

[[nodiscard]] inline bool is_opener(std::uint16_t type) {
  return type == RbtLexer::LPAREN || type == RbtLexer::LBRACK || type == RbtLexer::LBRACE;
}

[[nodiscard]] inline bool is_closer(std::uint16_t type) {
  return type == RbtLexer::RPAREN || type == RbtLexer::RBRACK || type == RbtLexer::RBRACE;
}

// The kind of closing bracket for a kind of opening one.
[[nodiscard]] inline std::uint16_t closer_of(std::uint16_t opener) {
  return opener == RbtLexer::LPAREN   ? RbtLexer::RPAREN
         : opener == RbtLexer::LBRACK ? RbtLexer::RBRACK
                                      : RbtLexer::RBRACE;
}

[[nodiscard]] inline bool is_primitive_type(std::uint16_t type) {
  return word_of(type).kind == WordKind::kType;
}

[[nodiscard]] inline bool is_number(std::uint16_t type) {
  return type == RbtLexer::INT || type == RbtLexer::FLOAT || type == RbtLexer::QUANTITY;
}

// Whether the token is a whole value: a number, a text, true or false.
[[nodiscard]] inline bool is_literal(std::uint16_t type) {
  return is_number(type) || type == RbtLexer::STRING || type == RbtLexer::FSTRING ||
         word_of(type).kind == WordKind::kTruth;
}

// Whether the keyword is followed by a header in parentheses.
[[nodiscard]] inline bool is_header_word(std::uint16_t type) { return word_of(type).has_header; }

// Whether a statement may end after it (section 3.1, token A).
[[nodiscard]] inline bool can_end_statement(std::uint16_t type) {
  return type == RbtLexer::ID || word_of(type).ends || mark_of(type).ends || is_literal(type);
}

}  // namespace armlet::lang
