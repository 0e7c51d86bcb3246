#pragma once
// Imports of other files: the names that an importing file can use, and the statements that an
// imported file may contain.

#include <string>
#include <string_view>

#include "check/explain/file_names.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

// The name of an import without `as`: the file's name without folders and ending.
[[nodiscard]] std::string imported_as(const ast::ImportStmt& stmt);

// Declares the names of the imported files.
void bind_imports(Checker& checker);

// Reports a name that the file does not declare, or that is private to it; false if there is
// nothing to report.
bool refuse_member(Checker& checker, const Checker& file, std::string_view import,
                   const ast::Name& member);
// Whether `member` is the name of a function of an imported file.
[[nodiscard]] const FunctionDecl* imported_function(Checker& checker, const ast::Expr& member);
// The struct or enum with this name: Side, or grip.Side of an imported file. null: none.
[[nodiscard]] const Type* declared_type(Checker& checker, std::string_view name);
// The qualified form of a name that an imported file declares and this one does not; empty if there
// is none.
[[nodiscard]] std::string imported_name(const Checker& checker, std::string_view name);
// A type with a file before it, grip.Side; `any` after a message.
const Type* imported_type(Checker& checker, const ast::TypeExpr& type);
// The function `name` of the file that declares `type`, for tray.slot(3); null if that is this
// file, or if it has no such function.
[[nodiscard]] FunctionDecl* method_of(Checker& checker, const Type* type, std::string_view name);
// Refuses grip.width = 3mm: imported variables are read-only.
void refuse_change(Checker& checker, const ast::Expr& place, Span statement);

// Refuses a host handle that two files declare under one name, since the world knows it by that
// name.
void refuse_second_owner(Checker& checker, const ast::ObjectStmt& stmt, const Type* type);

// Notes a statement of an imported file that is neither a declaration nor a test.
[[nodiscard]] bool is_active_statement(const Checker& checker, const ast::Stmt& stmt);
void check_active_statement(Checker& checker, const ast::Stmt& stmt);
// Reports statements that would act on a resource, or do anything else, during the import.
void refuse_active_statements(Checker& checker);
// Adds the initialisers of the imported files before the program.
void run_imports_first(Checker& main);

}  // namespace armlet::lang
