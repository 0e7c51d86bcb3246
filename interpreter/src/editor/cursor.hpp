#pragma once
// The context of the position where an author writes, found from the tokens, which exist even if
// the text cannot be parsed.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/facts.hpp"

namespace armlet::lang {

// The innermost call, settings or block declaration with an open bracket.
struct OpenCall {
  enum class Kind : std::uint8_t { kCall, kWith, kPath, kBlock } kind = Kind::kCall;
  std::string name{};                     // "run", "Math.sin"; kBlock: the type
  Span callee{};                          // the name without the part before a point
  bool behind_point = false;              // x.f(
  bool directly = true;                   // the position is not in a list inside of it
  int values = 0;                         // arguments by position before the current one
  std::string_view setting{};             // time: |
  std::vector<std::string_view> given{};  // names of settings in the call
  std::vector<Span> earlier{};            // arguments by position: first tokens
};

struct Cursor {
  std::uint32_t at = 0;
  Span word{};  // the word that is being written; may be empty
  bool in_comment = false;
  std::size_t before = 0;         // count of tokens before the word
  std::optional<Token> quoted{};  // the text literal with the position
  // The number with the position inside or at its end; `word` is its unit.
  std::optional<Token> number{};
  bool in_braces = false;        // inside of braces of a formatted text
  std::optional<Span> format{};  // after the colon in such braces: the span of the value before it
  std::optional<Token> point{};  // a point before the word
  std::optional<OpenCall> call{};
};

[[nodiscard]] Cursor cursor_at(const Facts& facts, std::uint32_t at);

// The library functions that a call may refer to.
[[nodiscard]] std::vector<const NativeFunction*> candidates(const Facts& facts,
                                                            const OpenCall& call);
// The script function or struct that the call refers to; null: none.
[[nodiscard]] const Symbol* callee_symbol(const Facts& facts, const OpenCall& call,
                                          std::uint32_t at);
// The parameter of a library function at the position; -1: none. The first argument may be before a
// point, or be absent.
[[nodiscard]] int parameter_of(const Facts& facts, const OpenCall& call,
                               const NativeFunction& function);
// The type of the value before the point; null: not known.
[[nodiscard]] const Type* receiver_type(const Facts& facts, const Token& point);

}  // namespace armlet::lang
