#pragma once
// The names that the entries of a session leave to the entries after them: the meaning of each
// name, the numbers of functions and variables in use, and which function uses which variable.
//
// Nothing here changes after an entry was compiled, so several sessions may continue from the same
// entry. The tables refer to the programs of earlier entries, which each program keeps alive.

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

// A function that was checked for given types of its parameters.
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

// The meaning of a name: exactly one of the last four members is set.
struct KeptName {
  std::string_view name;
  Span declared{};
  Declared how = Declared::kVar;  // variables: how they were declared, and the word that says so
  Span keyword{};
  bool maybe_unset = false;  // of variables: may be without a value
  const hir::Variable* variable = nullptr;
  std::shared_ptr<const KeptFunction> function;
  const Type* type = nullptr;
  const KeptFile* import = nullptr;
};

// The names visible at the end of a file: its own, and in the main file of an entry also those of
// the earlier entries.
struct KeptFile {
  using Bucket = std::vector<KeptName>;  // names with one key

  Span span{};  // the span of the whole file
  PersistentMap<Bucket> names;
  struct KeptImport {
    std::string path;
    const KeptFile* file;
  };
  std::vector<KeptImport> imports;

  [[nodiscard]] const KeptName* find(std::string_view name) const;
  void set(KeptName name);
};

// A variable that calls may omit, because the host declares its type as ambient.
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
  // The functions, tasks and lambdas that use a variable or call a function, by its use_key.
  PersistentMap<std::vector<std::string_view>> users;
  std::uint32_t functions = 0;  // count of numbers in use
  std::uint32_t globals = 0;
  std::vector<std::uint32_t> free_globals;  // numbers below `globals` that are free again

  [[nodiscard]] const KeptFile& main() const { return *files.back(); }
};

[[nodiscard]] inline std::uint64_t use_key(const hir::Variable& global) { return global.index; }
[[nodiscard]] inline std::uint64_t use_key(const hir::Function& function) {
  return std::uint64_t{1} << 32U | function.index;
}

}  // namespace armlet::lang
