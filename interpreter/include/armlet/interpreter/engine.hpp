#pragma once
// The door to the language: an Engine knows the vocabulary, compiles texts to Programs, and a Vm
// runs one.
//
// An Engine is set up once and then only read, so threads may share it. A Program never changes. A
// Vm belongs to one thread at a time; only `cancel` may be called by another thread. Nothing here
// throws for what a script does.

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

// Whether a prompt should take the text as an entry, or wait for more lines: brackets are open, or
// the last line goes on. The same rule ends statements in files.
//
// next_line  the line behind it, where that is known already, as in a pipe: it may go on with the
//            statement, as `else` and `.x` do.
[[nodiscard]] bool is_complete(std::string_view text, std::string_view next_line = {});

struct Compilation {
  std::shared_ptr<const Program> program;    // null if there were errors
  std::shared_ptr<const SourceSet> sources;  // also when it failed
  std::vector<Diagnostic> diagnostics;       // errors and advice in the order of the text
  bool cancelled = false;

  // All messages as people read them.
  [[nodiscard]] std::string text() const;
};

class Engine {
 public:
  Engine();
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  // The tables outlive the engine; signatures are read when first used. `chapter` is where the
  // reference lists them (reference.hpp).
  Engine& add_functions(std::span<const NativeFunction> functions,
                        std::string_view chapter = "Functions of the host");
  // Of functions that were added: those that do not act, command or take time only give a value.
  Engine& only_values(std::span<const NativeFunction> functions);
  // A function that `def` made (define.hpp), kept by the engine and its programs; its types exist.
  //
  // throws  ArgumentError: every difference between its signature and the C++ types is told.
  Engine& define(const Definition& definition, std::string_view chapter = "Functions of the host");
  // A type and its functions, that `type<T>` made (define_type.hpp).
  //
  // throws  ArgumentError with every mistake; the engine is as before then.
  Engine& define(const TypeDefinition& definition,
                 std::string_view chapter = "Functions of the host");
  Engine& add_constants(std::span<const NativeConstant> constants,
                        std::string_view chapter = "Functions of the host");
  Engine& add_type(const HostType& type);
  // A record of the library: add_record("Move", "reached: bool, stopped: bool, time: time, length:
  // length").
  Engine& add_record(std::string_view name, std::string_view fields);
  // Messages of the host, for its rules and failures. The rows outlive the engine.
  //
  // throws  ArgumentError as MessageTables::add.
  Engine& add_messages(std::span<const CatalogEntry> rows);
  [[nodiscard]] const MessageTables& messages() const;
  // What other languages call names of the library, for messages about unknown names. The texts
  // outlive the engine.
  //
  // throws  ArgumentError for a word that is known already.
  Engine& add_foreign_names(std::span<const ForeignName> rows);

  [[nodiscard]] Compilation compile(std::string text, std::string name,
                                    const CompileOptions& options = {}) const;
  // What a text means, also if it has mistakes (editor/analysis.hpp).
  //
  // before  an analysis of this engine of a text that is much alike: what has not changed since is
  //         not read again. The result does not depend on it. Null: none.
  [[nodiscard]] std::shared_ptr<const Analysis> analyse(
      std::string text, std::string name, const CompileOptions& options = {},
      const std::shared_ptr<const Analysis>& before = nullptr) const;
  // Every declared signature that cannot be read, with the reason; empty if all is well (for
  // tests).
  [[nodiscard]] std::vector<std::string> check_signatures() const;
  struct Vocabulary;  // the interpreter's own
  [[nodiscard]] const Vocabulary& registry() const { return vocabulary(); }

 private:
  [[nodiscard]] Vocabulary& vocabulary() const;  // throws ArgumentError if it was moved from
  std::shared_ptr<Vocabulary> registry_;         // programs keep it too
};

}  // namespace armlet
