#pragma once
// The analysis of a text for editors: a prompt, a page, a language server.
//
// An Analysis contains the results of the checker, also for a text with mistakes: the text is
// checked as if the missing parts were there. It never changes, any thread may read it, and it
// exists as long as it has an owner. Positions are bytes of the main text; a position inside of a
// character means that character, one beyond the end means the end.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

// The kind of a name.
enum class NameKind : std::uint8_t {
  kVariable,
  kParameter,
  kFunction,
  kStruct,
  kEnum,
  kField,
  kEnumValue,
  kModule,
  kLibraryFunction,
  kConstant,
  kType,
  kSetting,
  kWord,
  kText,  // between quotes
};
// "variable", "library function" ...
[[nodiscard]] std::string_view name_kind_text(NameKind kind);

// Information about a position.
struct Hover {
  Span span{};          // of the name or the expression
  std::string text{};   // "gap: length", "fn place(k: int) -> length", one line for each overload
  std::string help{};   // from the documentation; may be empty
  std::string value{};  // "30 mm", if it follows from the text
  std::vector<std::string> messages{};  // about this position: "E0401: this needs a unit"
};

struct Completion {
  std::string text{};  // the text to insert
  NameKind kind = NameKind::kVariable;
  std::string detail{};  // type or signature
};
struct Completions {
  Span replaced{};  // the word that is being written
  // The names in scope, the innermost first, then settings of the call, then the library. If a
  // setting has its value at the position, names with a fitting type come first. The list contains
  // all names that are possible there, regardless of the letters written so far.
  std::vector<Completion> items{};
};

// The call around a position.
struct SignatureHelp {
  struct Overload {
    std::string text{};  // "run(to: point, time: time?) -> Run"
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parameters{};  // bytes of `text`
    std::string help{};
  };
  std::vector<Overload> overloads{};
  std::size_t active = 0;  // the one that the checker selected, or the first
  int parameter = -1;      // of the active one; -1: none
};

struct Renaming {
  std::vector<Edit> edits{};  // in all files of the program
  std::string why{};          // without edits: the reason
};

struct InlayHint {
  std::uint32_t position = 0;  // the text is shown before this byte
  std::string text{};          // ": length"
};

class Analysis {
 public:
  struct Facts;  // the data of the analysis
  explicit Analysis(std::unique_ptr<const Facts> facts);
  ~Analysis();
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  [[nodiscard]] const SourceSet& sources() const;  // the main text is number first()
  // The messages of Engine::compile, except that fixes are not tried out and are therefore all
  // `maybe`.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  [[nodiscard]] bool was_cancelled() const;  // the analysis is then empty

  [[nodiscard]] std::optional<Hover> hover(std::uint32_t at) const;
  // The declaration of the name at `at`, perhaps in another file; empty for names of the library.
  [[nodiscard]] std::optional<Span> definition(std::uint32_t at) const;
  // All names that refer to the same declaration as the one at `at`, and the declaration, in the
  // order of files and texts.
  [[nodiscard]] std::vector<Span> references(std::uint32_t at) const;
  [[nodiscard]] Completions completion(std::uint32_t at) const;
  [[nodiscard]] std::optional<SignatureHelp> signature_help(std::uint32_t at) const;
  // Renames the declaration of the name at `at` and all references to it. Refused if it is not a
  // name of the program, or if the new name would conflict with another one.
  [[nodiscard]] Renaming rename(std::uint32_t at, std::string_view name) const;
  // The types of variables that are declared without one.
  [[nodiscard]] std::vector<InlayHint> inlay_hints() const;

  [[nodiscard]] const Facts& facts() const { return *facts_; }

 private:
  std::unique_ptr<const Facts> facts_;
};

}  // namespace armlet
