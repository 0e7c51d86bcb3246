#pragma once
// The position where the parser could not continue, with functions for the messages about it.

#include <algorithm>
#include <optional>
#include <string>

#include "armlet/interpreter/diagnostic.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {

class FailureSite {
 public:
  FailureSite(const Source& source, const Tokens& tokens, std::size_t first, std::size_t failing)
      : statement(first), at(failing), source_(source), tokens_(tokens) {}

  const std::size_t statement;  // the first token of the statement
  const std::size_t at;         // the token that does not fit

  [[nodiscard]] std::uint16_t type(std::size_t i) const {
    return i < tokens_.size() ? tokens_[i].type : kEndOfText;
  }
  [[nodiscard]] std::uint16_t before() const { return at == 0 ? kEndOfText : token(at - 1).type; }
  [[nodiscard]] bool inserted(std::size_t i) const { return token(i).inserted; }
  [[nodiscard]] bool starts_line(std::size_t i) const { return token(i).line_break_before; }

  // The count of characters before the first token of the line with token `i`.
  [[nodiscard]] std::size_t line_indent(std::size_t i) const {
    const std::string_view line = source_.line(source_.position(token(i).begin).line);
    return std::min(line.find_first_not_of(" \t"), line.size());
  }
  // The count of characters before token `i` on its line.
  [[nodiscard]] std::size_t column(std::size_t i) const {
    return static_cast<std::size_t>(source_.position(token(i).begin).column) - 1;
  }

  // The span from token `first` to token `last`.
  [[nodiscard]] Span span(std::size_t first, std::size_t last) const {
    return {token(first).begin, token(last).end, source_.id()};
  }
  [[nodiscard]] Span span(std::size_t i) const { return span(i, i); }
  // The empty span after token `i`.
  [[nodiscard]] Span after(std::size_t i) const {
    return {token(i).end, token(i).end, source_.id()};
  }
  [[nodiscard]] std::string text(std::size_t first, std::size_t last) const {
    return std::string(source_.slice(span(first, last)));
  }
  [[nodiscard]] std::string text(std::size_t i) const { return text(i, i); }
  // Whether no character, not even a blank, is between the two tokens.
  [[nodiscard]] bool touch(std::size_t left, std::size_t right) const {
    return right < tokens_.size() && token(left).end == token(right).begin;
  }
  // Whether no line break is between the two tokens.
  [[nodiscard]] bool on_one_line(std::size_t left, std::size_t right) const {
    for (std::size_t i = left + 1; i <= right; ++i) {
      if (token(i).line_break_before) return false;
    }
    return true;
  }

  // Whether a token before token `i` has the same text.
  [[nodiscard]] bool occurs_before(std::size_t i) const {
    const std::string name = text(i);
    for (std::size_t k = 0; k < i; ++k) {
      if (type(k) == type(i) && text(k) == name) return true;
    }
    return false;
  }

  // The innermost bracket of the statement that is open at token `i`.
  [[nodiscard]] std::optional<std::size_t> opener(std::size_t i) const {
    std::size_t depth = 0;
    while (i-- > statement) {
      if (is_closer(type(i))) ++depth;
      if (is_opener(type(i)) && depth-- == 0) return i;
    }
    return std::nullopt;
  }

  // The token that closes the bracket at token `open`.
  [[nodiscard]] std::size_t closer(std::size_t open) const {
    std::size_t depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      if (is_opener(type(i))) ++depth;
      if (is_closer(type(i)) && --depth == 0) return i;
    }
    return tokens_.size() - 1;
  }

  // The token that opens the bracket which token `close` closes.
  [[nodiscard]] std::size_t opener_of(std::size_t close) const {
    return opener(close).value_or(statement);
  }

  // The first token of the value that ends with token `last`, such as p[i].x.
  [[nodiscard]] std::size_t value_start(std::size_t last) const {
    while (true) {
      if (is_closer(type(last))) last = opener_of(last);
      if (last <= statement) return last;
      if (is_opener(type(last)) && ends_value(type(last - 1))) {
        --last;
      } else if (type(last - 1) == RbtLexer::DOT && last >= statement + 2) {
        last -= 2;
      } else {
        return last;
      }
    }
  }

  // Whether `(` at token `open` begins arguments, because it follows a value that can be called.
  [[nodiscard]] bool is_call(std::size_t open) const {
    if (open == 0) return false;
    const std::uint16_t callee = type(open - 1);
    return is_name(callee) || is_primitive_type(callee) || callee == RbtLexer::RPAREN ||
           callee == RbtLexer::RBRACK || callee == RbtLexer::WITH;
  }

  // Whether a value can start with this token.
  [[nodiscard]] static bool starts_value(std::uint16_t type) {
    return is_literal(type) || is_name(type) || type == RbtLexer::NEW || type == RbtLexer::FN;
  }
  // Whether a value can end with this token.
  [[nodiscard]] static bool ends_value(std::uint16_t type) {
    return is_literal(type) || is_name(type) || is_closer(type);
  }

 private:
  // The token with an index; the last one for larger indices.
  [[nodiscard]] const Token& token(std::size_t i) const {
    return tokens_[std::min(i, tokens_.size() - 1)];
  }

  const Source& source_;
  const Tokens& tokens_;
};

// The message for a habit from another language, or for a misused word or mark; empty if none is
// the cause.
[[nodiscard]] std::optional<Diagnostic> explain_habit(const FailureSite& site);
[[nodiscard]] std::optional<Diagnostic> explain_map_habit(const FailureSite& site);
[[nodiscard]] std::optional<Diagnostic> explain_sign(const FailureSite& site);
[[nodiscard]] std::optional<Diagnostic> explain_row(const FailureSite& site);
[[nodiscard]] std::optional<Diagnostic> explain_block(const FailureSite& site);

}  // namespace armlet::lang
