#pragma once
// Files that import each other: what an importing file sees of another one, and what an imported
// file may contain.

#include <string>
#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

[[nodiscard]] bool is_main_file(const Checker& checker);
// Of the file, without its folders.
[[nodiscard]] std::string file_name(const Checker& checker);
// "line 7", or "line 7 of grip.rbt" if that is not the file that `checker` is about.
[[nodiscard]] std::string line_phrase(const Checker& checker, Span span);

// What an import calls its file when it has no `as`: the file's name without folders and ending.
[[nodiscard]] std::string imported_as(const ast::ImportStmt& stmt);

// Gives the imported files the names that they have here.
void bind_imports(Checker& checker);

// grip.width, grip.close, grip.Side; after a message, a value that failed.
hir::Expr* imported_member(Checker& checker, const Import& from, const ast::MemberExpr& member,
                           const Type* expected);
// grip.close(5mm), grip.Part(mass: 2kg), grip.law(0.5).
hir::Expr* call_imported(Checker& checker, const Import& from, const ast::CallExpr& call,
                         const ast::MemberExpr& member);
// Whether `member` is the name of a function of an imported file.
[[nodiscard]] const FunctionDecl* imported_function(Checker& checker, const ast::Expr& member);
// The struct or enum called `name` here: Side, or grip.Side of an imported file. null: none.
[[nodiscard]] const Type* declared_type(Checker& checker, std::string_view name);
// How a name is written that an imported file declares and this one does not; empty if there is
// none.
[[nodiscard]] std::string imported_name(const Checker& checker, std::string_view name);
// A type written with a file in front, grip.Side; `any` after a message.
const Type* imported_type(Checker& checker, const ast::TypeExpr& type);
// The function `name` of the file that declares `type`, for tray.slot(3); null if that is no other
// file, or it has none.
[[nodiscard]] FunctionDecl* method_of(Checker& checker, const Type* type, std::string_view name);
// grip.width = 3mm: imported variables are read-only (ruling 8).
void refuse_change(Checker& checker, const ast::Expr& place, Span statement);

// A handle of the host declared in two files under one name, by which the world knows it.
void refuse_second_owner(Checker& checker, const ast::ObjectStmt& stmt, const Type* type);

// An imported file consists of declarations and tests: notes any other statement.
[[nodiscard]] bool is_active_statement(const Checker& checker, const ast::Stmt& stmt);
void check_active_statement(Checker& checker, const ast::Stmt& stmt);
// Reports what would command a resource, or do anything else, while the file is imported.
void refuse_active_statements(Checker& checker);
// Puts the imported files' first values in front of the program.
void run_imports_first(Checker& main);

}  // namespace armlet::lang
