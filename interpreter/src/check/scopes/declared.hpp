#pragma once
// What the top level of a file declares besides variables: imports, functions, structs.

#include <vector>

#include "ast/ast.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

struct Checker;

// A file that another one imports, under the name that it has there.
struct Import {
  Span span{};              // of the import
  Checker* file = nullptr;  // null: it could not be read, which was told
};

struct FunctionDecl;

// A function of the text for the types of one call.
struct Instance {
  std::vector<const Type*> types{};
  hir::Function* function = nullptr;
  bool result_known = false;
  bool checked = false;
  FunctionDecl* declaration = nullptr;
  Span first_call{};
};

// A function of the text, and its forms for the types it was called with.
struct FunctionDecl {
  const ast::FunctionStmt* node = nullptr;
  Checker* file = nullptr;                // where it is declared
  std::vector<const Type*> parameters{};  // null: generic by use
  const Type* result = nullptr;           // null: inferred
  std::vector<Instance*> instances{};
  bool failed = false;  // a form of it had errors
  [[nodiscard]] bool is_generic() const;
};

struct StructDecl {
  const ast::StructStmt* node = nullptr;
  Checker* file = nullptr;  // where it is declared
  const Type* type = nullptr;
};

}  // namespace armlet::lang
