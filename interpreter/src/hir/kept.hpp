#pragma once
// What the entries of a session leave for those behind them: their names and what these stand for,
// the numbers of functions and variables that are taken, and who uses what.
//
// Nothing here changes once an entry is compiled, so several sessions may go on from the same
// entry. What it refers to belongs to the programs before it, which a program keeps alive.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ast/ast.hpp"
#include "base/persistent_map.hpp"
#include "hir/hir.hpp"
#include "hir/program_names.hpp"

namespace armlet::lang {

struct KeptFile;

// How a variable was declared.
enum class Declared : std::uint8_t {
  kLet,
  kFinal,
  kVar,
  kClassic,
  kParameter,
  kLoop,
  kCatch,
  kBlock,
  kCapture
};

// The form of a function for the types of its parameters.
struct KeptInstance {
  std::vector<const Type*> types;
  hir::Function* function;
  bool pauses;  // it may wait or move
};

struct KeptFunction {
  const ast::FunctionStmt* node;
  const KeptFile* file;  // where it is declared
  std::vector<const Type*> parameters;
  const Type* result;
  std::vector<KeptInstance> instances;
};

// A struct or an enum.
struct KeptType {
  const ast::StructStmt* node;  // null: an enum
  const KeptFile* file;         // where it is declared
};

// What a name stands for: one of the last four.
struct KeptName {
  std::string_view name;
  Span declared{};
  Declared how = Declared::kVar;  // variables: how they were declared, and the word that says so
  Span keyword{};
  bool maybe_unset = false;  // variables: they may have got no value
  const hir::Variable* variable = nullptr;
  std::shared_ptr<const KeptFunction> function;
  const Type* type = nullptr;
  const KeptFile* import = nullptr;
};

// The names that can be seen at the end of a file: its own, and in the main file of an entry those
// of the entries before it.
struct KeptFile {
  using Bucket = std::vector<KeptName>;  // names with one key

  Span span{};  // the whole of it
  PersistentMap<Bucket> names;
  struct KeptImport {
    std::string path;
    const KeptFile* file;
  };
  std::vector<KeptImport> imports;

  [[nodiscard]] const KeptName* find(std::string_view name) const;
  void set(KeptName name);
};

// A variable that calls may leave out, since the host says so of its type.
struct KeptAmbient {
  std::string_view type;
  std::string_view name;
  const KeptFile* file;  // null: the session itself; otherwise an imported file
};

struct KeptNames {
  std::vector<std::unique_ptr<KeptFile>> files;          // of this entry; the main one last
  PersistentMap<KeptType> types;                         // by the address of the record or enum
  PersistentMap<std::vector<const KeptFile*>> imported;  // by name of the file
  std::shared_ptr<const std::vector<KeptAmbient>> ambient;
  std::shared_ptr<const BlockNames> blocks;
  // By use_key: the functions, or tasks and lambdas, that mention a variable or call a function.
  PersistentMap<std::vector<std::string_view>> users;
  std::uint32_t functions = 0;  // numbers that are taken
  std::uint32_t globals = 0;
  std::vector<std::uint32_t> free_globals;  // numbers below that which are free again

  [[nodiscard]] const KeptFile& main() const { return *files.back(); }
};

[[nodiscard]] inline std::uint64_t use_key(const hir::Variable& global) { return global.index; }
[[nodiscard]] inline std::uint64_t use_key(const hir::Function& function) {
  return std::uint64_t{1} << 32U | function.index;
}

}  // namespace armlet::lang
