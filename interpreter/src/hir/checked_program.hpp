#pragma once
// A program that was checked: the typed tree with its types, what a host asks of it, and what an
// entry of a session leaves for those behind it. The compiler makes code of it.

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

// The last statement of an entry, if it has a value to be shown.
struct ShownValue {
  const hir::Variable* variable = nullptr;  // which has the value; null: there is none
  bool is_declared = false;                 // the statement declares it; otherwise it is `ans`
  bool is_hidden = false;                   // a semicolon follows
};

// Names in the text that the host asks for.
struct UsedNames {
  std::vector<std::string> functions;                                     // of the library, sorted
  std::map<std::string, std::vector<std::string>, std::less<>> declared;  // by type
  bool of_world = false;  // one of the world that is not among the declared
};

// What an entry of a session has besides.
struct EntryParts {
  bool is_one = false;
  const KeptNames* before = nullptr;  // of the entry before it, while this one is checked
  std::unique_ptr<Arena> syntax;      // of functions and structs, which later calls check
  bool keeps_syntax = false;
  std::unique_ptr<const KeptNames> kept;
  ShownValue shown;
};

struct CheckedProgram {
  CheckedProgram() : CheckedProgram(nullptr, false) {}
  // before  the entry that this one goes on from; null: there is none.
  CheckedProgram(const CheckedProgram* before, bool is_entry);
  CheckedProgram(CheckedProgram&&) noexcept;
  CheckedProgram& operator=(CheckedProgram&&) noexcept;
  ~CheckedProgram();

  std::shared_ptr<SourceSet> sources;
  std::unique_ptr<Arena> arena;                   // hir
  std::shared_ptr<const TypePool> library_types;  // null: `types` are behind those of an entry
  std::shared_ptr<TypePool> types;  // those of the entry before it, if this one makes none
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
