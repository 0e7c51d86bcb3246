#pragma once
// A program that was checked: the typed tree with its types, the facts that a host asks for, and
// the names that one entry of a session leaves to the next ones. The compiler makes bytecode from
// it.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"
#include "base/arena.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

struct KeptNames;
struct LanguageFunctions;

// The variable whose value is shown after an entry of a session, if its last statement has a value.
struct ShownValue {
  const hir::Variable* variable = nullptr;  // which has the value; null: no value is shown
  bool is_declared = false;                 // the statement declares it; otherwise it is `ans`
  bool is_hidden = false;                   // a semicolon follows
};

// Names used in the text, for the host.
struct UsedNames {
  std::vector<std::string> functions;                                     // of the library, sorted
  std::map<std::string, std::vector<std::string>, std::less<>> declared;  // by type
  bool of_world = false;  // whether the text uses a name of the world that is not in `declared`
};

// The part of a checked program that exists only for entries of a session.
struct EntryParts {
  bool is_one = false;
  // The names of the entry before this one, while this one is checked.
  const KeptNames* before = nullptr;
  // The syntax of functions and structs, which later calls check again.
  std::unique_ptr<Arena> syntax;
  bool keeps_syntax = false;
  std::unique_ptr<const KeptNames> kept;
  ShownValue shown;
};

struct CheckedProgram {
  CheckedProgram() : CheckedProgram(nullptr, false) {}
  // before  the entry of the session that this one follows; null for the first one and for
  // programs.
  CheckedProgram(const CheckedProgram* before, bool is_entry);
  CheckedProgram(CheckedProgram&&) noexcept;
  CheckedProgram& operator=(CheckedProgram&&) noexcept;
  ~CheckedProgram();

  std::shared_ptr<SourceSet> sources;
  std::unique_ptr<Arena> arena;                   // of the typed tree
  std::shared_ptr<const TypePool> library_types;  // null: `types` follow those of an earlier entry
  std::shared_ptr<TypePool> types;  // those of the entry before it, if this one makes no types
  std::vector<std::shared_ptr<const Fact>> facts;
  std::vector<std::unique_ptr<Constant>> constants;
  hir::Module module;
  UsedNames names;
  std::string what_takes_time;              // in the words of the host: "wait or move"
  const MessageTables* messages = nullptr;  // of the engine, which outlives the program
  const LanguageFunctions* language = nullptr;
  EntryParts entry;
};

}  // namespace armlet::lang
