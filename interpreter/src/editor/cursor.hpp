#pragma once
// What stands around a position that is being written at, as far as the tokens show it: they do so
// also where nothing can be read.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/facts.hpp"

namespace armlet::lang {

// The innermost call, settings or block declaration whose bracket is open.
struct OpenCall {
  enum class Kind : std::uint8_t { kCall, kWith, kPath, kBlock } kind = Kind::kCall;
  std::string name{};                     // "run", "Math.sin"; kBlock: the type
  Span callee{};                          // the name without what stands in front of a point
  bool behind_point = false;              // x.f(
  bool directly = true;                   // the position is not in a list inside of it
  int values = 0;                         // by position, in front of the one that is written
  std::string_view setting{};             // time: |
  std::vector<std::string_view> given{};  // names of settings in it
  std::vector<Span> earlier{};            // values by position, first tokens
};

struct Cursor {
  std::uint32_t at = 0;
  Span word{};  // that is being written; may be empty
  bool in_comment = false;
  std::size_t before = 0;         // tokens in front of the word
  std::optional<Token> quoted{};  // the text that the position is in
  std::optional<Token> number{};  // the number that it is in, or ends; `word` is its unit
  bool in_braces = false;         // of a formatted text
  std::optional<Span> format{};   // behind the colon in such braces: the value in front of it
  std::optional<Token> point{};   // in front of the word
  std::optional<OpenCall> call{};
};

[[nodiscard]] Cursor cursor_at(const Facts& facts, std::uint32_t at);

// The functions of the library that a call can mean.
[[nodiscard]] std::vector<const NativeFunction*> candidates(const Facts& facts,
                                                            const OpenCall& call);
// The function or struct of the text that it means; null: none.
[[nodiscard]] const Symbol* callee_symbol(const Facts& facts, const OpenCall& call,
                                          std::uint32_t at);
// The parameter of a library function that is written at the position; -1: none. The first one may
// stand in front of a point, or be left out.
[[nodiscard]] int parameter_of(const Facts& facts, const OpenCall& call,
                               const NativeFunction& function);
// The type of what stands in front of the point; null: not known.
[[nodiscard]] const Type* receiver_type(const Facts& facts, const Token& point);

}  // namespace armlet::lang
