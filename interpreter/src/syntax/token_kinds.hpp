#pragma once
// Questions about kinds of tokens that several stages ask.

#include <RbtLexer.h>

#include "syntax/token.hpp"

namespace armlet::lang {

[[nodiscard]] inline bool is_name(std::uint16_t type) {
  return type == RbtLexer::ID || type == RbtLexer::TEST || type == RbtLexer::RECORD ||
         type == RbtLexer::PATH || type == RbtLexer::AS;
}

[[nodiscard]] inline bool is_opener(std::uint16_t type) {
  return type == RbtLexer::LPAREN || type == RbtLexer::LBRACK || type == RbtLexer::LBRACE;
}

[[nodiscard]] inline bool is_closer(std::uint16_t type) {
  return type == RbtLexer::RPAREN || type == RbtLexer::RBRACK || type == RbtLexer::RBRACE;
}

// The closing bracket that belongs to an opening one.
[[nodiscard]] inline std::uint16_t closer_of(std::uint16_t opener) {
  return opener == RbtLexer::LPAREN   ? RbtLexer::RPAREN
         : opener == RbtLexer::LBRACK ? RbtLexer::RBRACK
                                      : RbtLexer::RBRACE;
}

[[nodiscard]] inline bool is_primitive_type(std::uint16_t type) {
  return type == RbtLexer::INT_T || type == RbtLexer::DOUBLE_T || type == RbtLexer::BOOL_T;
}

[[nodiscard]] inline bool is_number(std::uint16_t type) {
  return type == RbtLexer::INT || type == RbtLexer::FLOAT || type == RbtLexer::QUANTITY;
}

// A value that consists of one token.
[[nodiscard]] inline bool is_literal(std::uint16_t type) {
  return is_number(type) || type == RbtLexer::STRING || type == RbtLexer::FSTRING ||
         type == RbtLexer::TRUE || type == RbtLexer::FALSE;
}

// Words that open the parentheses of a header.
[[nodiscard]] inline bool is_header_word(std::uint16_t type) {
  switch (type) {
    case RbtLexer::IF:
    case RbtLexer::WHILE:
    case RbtLexer::FOR:
    case RbtLexer::SWITCH:
    case RbtLexer::CATCH:
    case RbtLexer::WHEN:
    case RbtLexer::EVERY:
      return true;
    default:
      return false;
  }
}

// Whether a statement may end after it (section 3.1, token A).
[[nodiscard]] inline bool can_end_statement(std::uint16_t type) {
  if (is_name(type) || is_literal(type) || is_primitive_type(type) || is_closer(type)) return true;
  switch (type) {
    case RbtLexer::RETURN:
    case RbtLexer::BREAK:
    case RbtLexer::CONTINUE:
    case RbtLexer::RETRY:
    case RbtLexer::INC:
    case RbtLexer::DEC:
      return true;
    default:
      return false;
  }
}

}  // namespace armlet::lang
