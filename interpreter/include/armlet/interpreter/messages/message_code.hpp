#pragma once
// Codes of messages that are checked at compile time: an unknown code, or a headline with another
// count of arguments, does not compile.
//
// Codes of the language are texts: make_diagnostic("E0201", span, {name}). Codes of a host are rows
// of its constant table: make_diagnostic(kRows[0], span, {name}).

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace armlet {

struct CatalogEntry {
  std::string_view code;      // "E0401"
  std::string_view kind;      // of an error that a program can catch ("Timeout"); otherwise empty
  std::string_view headline;  // with {} for each argument
  std::string_view page;      // the explanation, with a wrong and a right program

  // The count of arguments of the headline.
  [[nodiscard]] constexpr std::size_t argument_count() const {
    std::size_t count = 0;
    for (std::size_t at = headline.find("{}"); at != std::string_view::npos;
         at = headline.find("{}", at + 2)) {
      ++count;
    }
    return count;
  }
};

namespace message_code {

struct Row {
  std::string_view code;
  std::size_t arguments;
};

// The codes of the language, in order.
#define ARMLET_MESSAGE(code, kind, headline, page) \
  Row{#code, CatalogEntry{{}, {}, headline, {}}.argument_count()},
inline constexpr auto kRows = std::to_array<Row>({
// clang-format off
#include "armlet/interpreter/messages/text.def"
#include "armlet/interpreter/messages/names.def"
#include "armlet/interpreter/messages/types.def"
#include "armlet/interpreter/messages/units.def"
#include "armlet/interpreter/messages/tasks.def"
#include "armlet/interpreter/messages/running.def"
#include "armlet/interpreter/messages/advice.def"
    // clang-format on
});
#undef ARMLET_MESSAGE

// Not constexpr, so that a call of it in a constant expression is an error of the compiler, which
// shows the reason.
inline void refuse(const char* /*why*/) {}

// The index of a code among them.
consteval std::size_t place_of(std::string_view code) {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].code == code) return i;
  refuse("the language has no message with this code");
  return 0;
}

}  // namespace message_code

// The row of the language with index `place`.
[[nodiscard]] const CatalogEntry& language_row(std::size_t place);

// A code that exists.
class KnownCode {
 public:
  consteval KnownCode(const char* code) : place_(message_code::place_of(code)) {}
  // `row` must outlive the code: it belongs to the constant table of a host.
  constexpr KnownCode(const CatalogEntry& row) : row_(&row) {}
  [[nodiscard]] const CatalogEntry& row() const {
    return row_ != nullptr ? *row_ : language_row(place_);
  }

 private:
  const CatalogEntry* row_ = nullptr;  // null: a code of the language
  std::size_t place_ = 0;
};

// A code whose headline takes N arguments.
template <std::size_t N>
class MessageCode {
 public:
  consteval MessageCode(const char* code) : code_(code) {
    if (message_code::kRows[message_code::place_of(code)].arguments != N)
      message_code::refuse("the headline of this code takes another number of arguments");
  }
  consteval MessageCode(const CatalogEntry& row) : code_(row) {
    if (row.argument_count() != N)
      message_code::refuse("the headline of this code takes another number of arguments");
  }
  [[nodiscard]] const CatalogEntry& row() const { return code_.row(); }

 private:
  KnownCode code_;
};

// The type of a parameter of a function template whose arguments determine N.
template <std::size_t N>
using CodeFor = std::type_identity_t<MessageCode<N>>;

// The headline of a message: that of the catalogue with its arguments, or a sentence that replaces
// it.
class Headline {
 public:
  // An empty headline.
  Headline() = default;
  explicit Headline(MessageCode<0> code) : row_(&code.row()), text_(code.row().headline) {}
  template <std::size_t N>
  Headline(CodeFor<N> code, const std::string (&arguments)[N])
      : Headline(code.row(), std::span<const std::string>(arguments)) {}
  // A headline with a sentence that replaces the one of the catalogue.
  [[nodiscard]] static Headline own(KnownCode code, std::string sentence);
  // The headline of a row that is only known at run time; the row must outlive the headline.
  // throws  ArgumentError if the headline has another count of arguments.
  [[nodiscard]] static Headline of(const CatalogEntry& row, std::span<const std::string> arguments);

  // Null for an empty headline.
  [[nodiscard]] const CatalogEntry* row() const { return row_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Headline(const CatalogEntry& row, std::span<const std::string> arguments);

  const CatalogEntry* row_ = nullptr;
  std::string text_;
};

}  // namespace armlet
