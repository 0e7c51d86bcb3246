#pragma once
// What an analysis keeps: trees, types, names and what they refer to, by position.

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

// Something that a text declares.
struct Symbol {
  NameKind kind = NameKind::kVariable;
  std::string_view name{};
  Span declared{};             // the name
  const Type* type = nullptr;  // of variables and fields; null: not known
  Span visible{};              // where it can be seen; fields and values of enums: nowhere
  bool is_typed = false;       // of variables: the type is written, or no value is
  bool of_file = false;        // also seen in functions, wherever they stand
  std::string_view doc{};
  std::string_view header{};                    // of functions and structs, as written
  const ast::FunctionStmt* function = nullptr;  // kFunction
  const ast::StructStmt* structure = nullptr;   // kStruct
  const ast::EnumStmt* enumeration = nullptr;   // kEnum
  const Type* values = nullptr;                 // kEnum of an earlier entry: the type
  std::uint32_t scope = 0;                      // length of the scope that it belongs to
};

// A name that refers to a symbol.
struct Reference {
  Span name{};
  std::uint32_t symbol = 0;
};

// A value in the text: its bytes, and the place in ValueIndex::spans.
struct TypedSpan {
  Span span{};
  const Type* type = nullptr;
  const ast::Expr* written = nullptr;
};

// From a byte on, the innermost of some nested spans; kNothing: none.
class InnermostSpans {
 public:
  static constexpr std::uint32_t kNothing = 0xFFFFFFFF;

  InnermostSpans() = default;
  // Sorted by begin, longer ones first; they nest.
  explicit InnermostSpans(std::span<const Span> spans);
  [[nodiscard]] std::uint32_t at(std::uint32_t byte) const;

 private:
  struct Segment {
    std::uint32_t begin;
    std::uint32_t span;
  };
  std::vector<Segment> segments_;
};

// Functions of the library by how they can be used behind a dot are asked for with the types of
// this analysis, which grow while they are asked for: one query at a time.
struct Signed {
  Signed(const Registry& registry, TypePool& types) : signatures(registry, types) {}
  std::mutex mutex{};
  Signatures signatures;
};

// Names and what they refer to.
struct NameIndex {
  std::vector<Symbol> symbols{};        // by source and position of the declaration
  std::vector<Reference> references{};  // by position; declarations are among them
  std::vector<Reference> by_symbol{};   // the same by symbol, then position
};

// Values of the main text.
struct ValueIndex {
  std::vector<TypedSpan> spans{};  // outer ones first
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

  // Sources, types, the typed tree.
  CheckedProgram compiled = new_program(options);
  Arena tree{};  // of all files
  std::vector<FileTree> files{};
  Tokens tokens{};  // of the main text
  std::vector<Span> comments{};
  std::vector<ReadStatement> read{};  // of the main text
  bool is_whole = false;              // all statements of the main text can be read
  Learnt learnt{};

  NameIndex names{};
  ValueIndex values{};
  std::vector<Learnt::NativeUse> natives{};       // of the main text, by position
  std::vector<const ast::MemberExpr*> members{};  // of the main text, by the position of the member
  std::vector<Span> functions{};  // of the main text: bodies that see all of its file
  std::unique_ptr<Signed> signed_{};

  [[nodiscard]] const Source& main() const { return (*compiled.sources)[main_source()]; }
  // Its number: in a session, texts of earlier entries come before it.
  [[nodiscard]] std::uint32_t main_source() const { return compiled.sources->first(); }
  // A position as the documentation of Analysis says.
  [[nodiscard]] std::uint32_t place(std::uint32_t at) const;
  // The name that stands at a byte of the main text, or ends there.
  [[nodiscard]] const Reference* reference_at(std::uint32_t at) const;
  [[nodiscard]] const Learnt::NativeUse* native_at(std::uint32_t at) const;
  // The symbol declared there; null: none.
  [[nodiscard]] const Symbol* declared_at(Span name) const;
  // Of names.by_symbol, those of one of names.symbols.
  [[nodiscard]] std::span<const Reference> uses_of(const Symbol& symbol) const;
  // All that can be seen at a byte of the main text, innermost first; hidden ones are left out.
  [[nodiscard]] std::vector<const Symbol*> visible_at(std::uint32_t at) const;
  [[nodiscard]] const Symbol* visible_at(std::uint32_t at, std::string_view name) const;
  // The token that a byte is in, or that ends there; the index of the one behind it otherwise.
  [[nodiscard]] std::size_t token_behind(std::uint32_t at) const;
  [[nodiscard]] std::string_view text_of(const Token& token) const {
    return main().slice({token.begin, token.end, main_source()});
  }
  [[nodiscard]] bool in_comment(std::uint32_t at) const;
};

// Fills what is derived from the trees and from `learnt`.
void index_facts(Facts& facts);

// "gap: length", with what the text says about it.
[[nodiscard]] std::string described(const Facts& facts, const Symbol& symbol);

}  // namespace armlet::lang

namespace armlet {
struct Analysis::Facts : lang::Facts {
  using lang::Facts::Facts;
};
}  // namespace armlet
