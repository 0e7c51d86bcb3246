#pragma once
// The data of an analysis: trees, types, names and their declarations, by position.

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/engine.hpp"
#include "base/arena.hpp"
#include "check/check.hpp"
#include "check/state/learnt.hpp"
#include "check/state/signatures.hpp"
#include "program/program.hpp"
#include "syntax/read_before.hpp"
#include "syntax/tokens/token.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

// A declared name.
struct Symbol {
  NameKind kind = NameKind::kVariable;
  std::string_view name{};
  Span declared{};             // the span of the name
  const Type* type = nullptr;  // of variables and fields; null: not known
  Span visible{};              // where it is visible; empty for fields and values of enums
  bool is_typed = false;       // of variables: the type is in the text, or there is no first value
  bool of_file = false;        // visible in functions of the whole file
  std::string_view doc{};
  std::string_view header{};                    // of functions and structs, from the text
  const ast::FunctionStmt* function = nullptr;  // kFunction
  const ast::StructStmt* structure = nullptr;   // kStruct
  const ast::EnumStmt* enumeration = nullptr;   // kEnum
  const Type* values = nullptr;                 // kEnum of an earlier entry: the type
  std::uint32_t scope = 0;                      // the length of its scope, bytes
};

// A name that refers to a symbol.
struct Reference {
  Span name{};
  std::uint32_t symbol = 0;
};

// A value in the text: its bytes, and its index in ValueIndex::spans.
struct TypedSpan {
  Span span{};
  const Type* type = nullptr;
  const ast::Expr* written = nullptr;
};

// Finds the innermost of nested spans: for each byte where it changes, the index of the span;
// kNothing: none.
class InnermostSpans {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFFFFFF;

  InnermostSpans() = default;
  // The spans must be nested, and sorted by begin, longer ones first.
  explicit InnermostSpans(std::span<const Span> spans);
  [[nodiscard]] std::uint32_t at(std::uint32_t byte) const;

 private:
  struct Segment {
    std::uint32_t begin;
    std::uint32_t span;
  };
  std::vector<Segment> segments_;
};

// The signatures of library functions for completions after a point. They are parsed with the types
// of this analysis, to which each query may add types, so only one query runs at a time.
struct Signed {
  Signed(const Registry& registry, TypePool& types) : signatures(registry, types) {}
  std::mutex mutex{};
  Signatures signatures;
};

// Names with their declarations.
struct NameIndex {
  std::vector<Symbol> symbols{};        // by source and position of the declaration
  std::vector<Reference> references{};  // by position; declarations are among them
  std::vector<Reference> by_symbol{};   // the same by symbol, then position
};

// The values of the main text.
struct ValueIndex {
  std::vector<TypedSpan> spans{};  // the outer ones first
  InnermostSpans innermost{};      // of `spans`
  std::unordered_map<const ast::Expr*, const Type*> type_of{};
};

struct Facts {
  Facts(std::shared_ptr<const Registry> vocabulary, CompileOptions how)
      : registry(std::move(vocabulary)), options(std::move(how)) {}

  std::shared_ptr<const Registry> registry;
  CompileOptions options;
  std::vector<Diagnostic> diagnostics{};
  bool cancelled = false;

  // Sources, types and the typed tree.
  CheckedProgram compiled = new_program(options);
  Arena tree{};  // of all files
  std::vector<FileTree> files{};
  Tokens tokens{};  // of the main text
  std::vector<Span> comments{};
  std::vector<ReadStatement> read{};  // of the main text
  bool is_whole = false;              // all statements of the main text can be parsed
  Learnt learnt{};

  NameIndex names{};
  ValueIndex values{};
  std::vector<Learnt::NativeUse> natives{};       // of the main text, by position
  std::vector<const ast::MemberExpr*> members{};  // of the main text, by the position of the member
  std::vector<Span> functions{};  // of the main text: bodies that can use all names of the file
  std::unique_ptr<Signed> signed_{};

  [[nodiscard]] const Source& main() const { return (*compiled.sources)[main_source()]; }
  // The number of the main source. In a session the texts of earlier entries come before it.
  [[nodiscard]] std::uint32_t main_source() const { return compiled.sources->first(); }
  // A position clipped to the text, as the documentation of Analysis defines.
  [[nodiscard]] std::uint32_t place(std::uint32_t at) const;
  // The name in the main text that contains a byte or ends there.
  [[nodiscard]] const Reference* reference_at(std::uint32_t at) const;
  [[nodiscard]] const Learnt::NativeUse* native_at(std::uint32_t at) const;
  // The symbol that is declared there; null: none.
  [[nodiscard]] const Symbol* declared_at(Span name) const;
  // The references in names.by_symbol to a symbol of names.symbols.
  [[nodiscard]] std::span<const Reference> uses_of(const Symbol& symbol) const;
  // All symbols that are visible at a byte of the main text, the innermost first, without hidden
  // ones.
  [[nodiscard]] std::vector<const Symbol*> visible_at(std::uint32_t at) const;
  [[nodiscard]] const Symbol* visible_at(std::uint32_t at, std::string_view name) const;
  // The index of the token that contains a byte or ends there; otherwise that of the next token.
  [[nodiscard]] std::size_t token_behind(std::uint32_t at) const;
  [[nodiscard]] std::string_view text_of(const Token& token) const {
    return main().slice({token.begin, token.end, main_source()});
  }
  [[nodiscard]] bool in_comment(std::uint32_t at) const;
};

// Fills the tables that follow from the trees and from `learnt`.
void index_facts(Facts& facts);

// The description of a symbol, such as "gap: length", with its documentation in the text.
[[nodiscard]] std::string described(const Facts& facts, const Symbol& symbol);

}  // namespace armlet::lang

namespace armlet {
struct Analysis::Facts : lang::Facts {
  using lang::Facts::Facts;
};
}  // namespace armlet
