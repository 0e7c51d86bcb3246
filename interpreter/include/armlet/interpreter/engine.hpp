#pragma once
// The main interface of the language: an Engine has the vocabulary and compiles texts to Programs;
// a Vm runs one.
//
// An Engine is set up once and then only read, so threads may share it. A Program never changes. A
// Vm belongs to one thread at a time; only `cancel` may be called by another thread. Mistakes of a
// program cause no exceptions here.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/foreign_name.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "armlet/interpreter/host/program.hpp"
#include "armlet/interpreter/host/vm.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/source.hpp"

namespace armlet {

struct Definition;
class TypeDefinition;
class Analysis;
class MessageTables;

// Whether a prompt should execute the text as an entry. False: it should wait for more lines,
// because a bracket is open or the last line is incomplete. Statements in files end by the same
// rule.
//
// next_line  the line after it, if it is known already, as in a pipe: it may continue the
//            statement, as `else` and `.x` do.
[[nodiscard]] bool is_complete(std::string_view text, std::string_view next_line = {});

struct Compilation {
  std::shared_ptr<const Program> program;    // null if there were errors
  std::shared_ptr<const SourceSet> sources;  // also if it failed
  std::vector<Diagnostic> diagnostics;       // errors and advice in the order of the text
  bool cancelled = false;

  // All messages as text.
  [[nodiscard]] std::string text() const;
};

class Engine {
 public:
  Engine();
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  // Adds functions. The tables must outlive the engine; signatures are parsed at their first use.
  // `chapter` is their chapter in the reference (reference.hpp).
  Engine& add_functions(std::span<const NativeFunction> functions,
                        std::string_view chapter = "Functions of the host");
  // Names functions whose only effect is their result, apart from those that act, command or take
  // time. The functions must have been added.
  Engine& only_values(std::span<const NativeFunction> functions);
  // Adds a function made by `def` (define.hpp), which the engine and its programs keep. Its types
  // must have been added.
  //
  // throws  ArgumentError with every difference between its signature and the C++ types.
  Engine& define(const Definition& definition, std::string_view chapter = "Functions of the host");
  // Adds a type with its functions, made by `type<T>` (define_type.hpp).
  //
  // throws  ArgumentError with every mistake; the engine is then unchanged.
  Engine& define(const TypeDefinition& definition,
                 std::string_view chapter = "Functions of the host");
  Engine& add_constants(std::span<const NativeConstant> constants,
                        std::string_view chapter = "Functions of the host");
  Engine& add_type(const HostType& type);
  // Adds a record of the library: add_record("Move", "reached: bool, stopped: bool, time: time,
  // length: length").
  Engine& add_record(std::string_view name, std::string_view fields);
  // Adds messages of the host, for its rules and failures. The rows must outlive the engine.
  //
  // throws  ArgumentError as MessageTables::add.
  Engine& add_messages(std::span<const CatalogEntry> rows);
  [[nodiscard]] const MessageTables& messages() const;
  // Adds names of other languages for functions of the library, for messages about unknown names.
  // The texts must outlive the engine.
  //
  // throws  ArgumentError for a word that was added before.
  Engine& add_foreign_names(std::span<const ForeignName> rows);

  [[nodiscard]] Compilation compile(std::string text, std::string name,
                                    const CompileOptions& options = {}) const;
  // Analyses a text for editors, also with mistakes (editor/analysis.hpp).
  //
  // before  an analysis of a similar text by this engine: parts that are unchanged are not parsed
  //         again. The result does not depend on it. Null: none.
  [[nodiscard]] std::shared_ptr<const Analysis> analyse(
      std::string text, std::string name, const CompileOptions& options = {},
      const std::shared_ptr<const Analysis>& before = nullptr) const;
  // The invalid signatures, each with the reason; empty if there are none (for tests).
  [[nodiscard]] std::vector<std::string> check_signatures() const;
  struct Vocabulary;  // internal
  [[nodiscard]] const Vocabulary& registry() const { return vocabulary(); }

 private:
  [[nodiscard]] Vocabulary& vocabulary() const;  // throws ArgumentError if it was moved from
  std::shared_ptr<Vocabulary> registry_;         // shared with the programs
};

}  // namespace armlet
