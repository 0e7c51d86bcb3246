#pragma once
// Declarations at the top level of a file other than variables: imports, functions, structs.

#include <vector>

#include "ast/ast.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

struct Checker;

// A file that another one imports, with its name there.
struct Import {
  Span span{};              // of the import
  Checker* file = nullptr;  // null: it could not be read, which was reported
};

struct FunctionDecl;

// A script function, checked for the argument types of one call.
struct Instance {
  std::vector<const Type*> types{};
  hir::Function* function = nullptr;
  bool result_known = false;
  bool checked = false;
  FunctionDecl* declaration = nullptr;
  Span first_call{};
};

// A script function, with its forms for different argument types.
struct FunctionDecl {
  const ast::FunctionStmt* node = nullptr;
  Checker* file = nullptr;                // that declares it
  std::vector<const Type*> parameters{};  // null: without a declared type
  const Type* result = nullptr;           // null: inferred
  std::vector<Instance*> instances{};
  bool failed = false;  // one of its forms had errors
  [[nodiscard]] bool is_generic() const;
};

struct StructDecl {
  const ast::StructStmt* node = nullptr;
  Checker* file = nullptr;  // that declares it
  const Type* type = nullptr;
};

}  // namespace armlet::lang
