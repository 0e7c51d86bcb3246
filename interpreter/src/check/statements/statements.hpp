#pragma once
// Statements that are no loops, no switches and no declarations.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

void append(const ast::Stmt& stmt, hir::Stmt* checked, std::vector<hir::Stmt*>& out);
// Whether a statement that consists of an expression is there for its value or its effect: `assert`
// and others look like calls, and are statements.
[[nodiscard]] bool is_value_statement(Checker& checker, const ast::ExprStmt& stmt);
hir::Stmt* return_value(Checker& checker, hir::Expr* value, Span span);
hir::Expr* seconds(Checker& checker, const ast::Expr& written, std::string_view what);

}  // namespace armlet::lang
