#pragma once
// What a text means, for whoever shows it while it is written: a prompt, a page, a language server.
//
// An Analysis keeps what the checker found out, also where the text is broken: the rest of it is
// read as if what is missing were there. It never changes, any thread may ask it, and it lives as
// long as somebody holds it. Positions are bytes of the main text; one inside of a character means
// the character, one behind the end the end.

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

// What a name stands for.
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

// What stands at a position.
struct Hover {
  Span span{};          // of the name or the expression
  std::string text{};   // "gap: length", "fn place(k: int) -> length", one line for each overload
  std::string help{};   // what the documentation says; may be empty
  std::string value{};  // "30 mm", where the text alone gives it
  std::vector<std::string> messages{};  // about this position: "E0401: this needs a unit"
};

struct Completion {
  std::string text{};  // what is put in
  NameKind kind = NameKind::kVariable;
  std::string detail{};  // type or signature
};
struct Completions {
  Span replaced{};  // the word that is being written
  // Names in scope, innermost first, then
  // settings of the call, then the library. Where a setting has its value, names whose type fits
  // come first. All names that can stand here, whatever has been written of the word.
  std::vector<Completion> items{};
};

// The call that a position is in.
struct SignatureHelp {
  struct Overload {
    std::string text{};  // "run(to: point, time: time?) -> Run"
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parameters{};  // bytes of `text`
    std::string help{};
  };
  std::vector<Overload> overloads{};
  std::size_t active = 0;  // the one that the checker chose, or the first
  int parameter = -1;      // of the active one; -1: none
};

struct Renaming {
  std::vector<Edit> edits{};  // in all files of the program
  std::string why{};          // without edits: why it is not done
};

struct InlayHint {
  std::uint32_t position = 0;  // the text is shown in front of this byte
  std::string text{};          // ": length"
};

class Analysis {
 public:
  struct Facts;  // what was found out
  explicit Analysis(std::unique_ptr<const Facts> facts);
  ~Analysis();
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  [[nodiscard]] const SourceSet& sources() const;  // the main text is number first()
  // The messages of Engine::compile, but fixes are not tried out: they are all `maybe`.
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const;
  [[nodiscard]] bool was_cancelled() const;  // then nothing is known of the text

  [[nodiscard]] std::optional<Hover> hover(std::uint32_t at) const;
  // The name where the thing at `at` is declared, perhaps in another file; empty for the library.
  [[nodiscard]] std::optional<Span> definition(std::uint32_t at) const;
  // Every name that means the same as the one at `at`, its declaration included, in the order of
  // files and texts.
  [[nodiscard]] std::vector<Span> references(std::uint32_t at) const;
  [[nodiscard]] Completions completion(std::uint32_t at) const;
  [[nodiscard]] std::optional<SignatureHelp> signature_help(std::uint32_t at) const;
  // Gives the thing at `at` another name. Refused for what is no name of the program, and where the
  // new name would mean something else.
  [[nodiscard]] Renaming rename(std::uint32_t at, std::string_view name) const;
  // Types of variables that are declared without one.
  [[nodiscard]] std::vector<InlayHint> inlay_hints() const;

  [[nodiscard]] const Facts& facts() const { return *facts_; }

 private:
  std::unique_ptr<const Facts> facts_;
};

}  // namespace armlet
